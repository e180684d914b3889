// Bundles the player into one classic script: pages opened from a disk may not load modules.
//   npm install && npm run build
import { readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const licence = readFileSync('node_modules/three/LICENSE', 'utf8').trim();
const result = await build({
  entryPoints: ['src/replay.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2021',
  charset: 'ascii',
  loader: { '.css': 'text' },
  legalComments: 'none',
  banner: { js: `/*! Carom's player of recordings. It contains three.js 0.187.0:\n${licence}\n*/` },
  write: false,
});
const text = result.outputFiles[0].text;
// The script stands inside a page, where these two would end it or confuse the browser about where it ends.
if (/<\/script|<!--/i.test(text)) throw new Error('the bundle contains </script or <!--');
writeFileSync('dist/replay.js', text);
writeFileSync('dist/LICENSE.three', licence + '\n');
console.log(`dist/replay.js: ${text.length} bytes`);
