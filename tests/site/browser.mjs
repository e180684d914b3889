// Drives Chromium through its debugging pipe: no packages, no ports, no web server.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Browser {
  constructor(executable) {
    this.profile = mkdtempSync(join(tmpdir(), 'carom-site-'));
    this.process = spawn(executable, [
      '--headless=new', '--no-sandbox', '--remote-debugging-pipe', '--no-first-run', '--disable-extensions',
      '--disable-background-networking', '--disable-component-update', '--disable-sync', '--mute-audio',
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
      `--user-data-dir=${this.profile}`, 'about:blank',
    ], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.pending = new Map();
    this.listeners = new Map();
    this.nextId = 1;
    let unread = '';
    this.process.stdio[4].on('data', chunk => {
      const messages = (unread + chunk.toString('utf8')).split('\0');
      unread = messages.pop();
      messages.forEach(message => this.receive(JSON.parse(message)));
    });
    this.process.stdio[4].setEncoding('utf8');
    this.ended = new Promise(resolve => this.process.on('exit', resolve));
    this.ended.then(() => this.pending.forEach(({ reject }) => reject(new Error('the browser has ended'))));
  }

  receive(message) {
    if (message.id) {
      const { resolve, reject } = this.pending.get(message.id);
      this.pending.delete(message.id);
      message.error ? reject(new Error(message.error.message)) : resolve(message.result);
    } else {
      this.listeners.get(message.sessionId)?.(message.method, message.params);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.nextId++;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((resolve, reject) => this.pending.set(id, { resolve, reject }));
  }

  // A tab: `listener(method, params)` hears its events.
  async openTab(listener, width = 1200, height = 900) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank', newWindow: true, width, height });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    this.listeners.set(sessionId, listener);
    const tab = (method, params) => this.send(method, params, sessionId);
    for (const domain of ['Page', 'Runtime', 'Network', 'Log']) {
      await tab(`${domain}.enable`);
    }
    return tab;
  }

  async close() {
    this.send('Browser.close').catch(() => {});
    const killer = setTimeout(() => this.process.kill('SIGKILL'), 5000);
    await this.ended;
    clearTimeout(killer);
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
