// Dark or light? Inside a page of the site, as the site is: its root element has class dark-mode or light-mode. Pages opened
// from a disk may not look at the page around them, so the site may also send the message {caromDark: true or false};
// the player asks for it with {caromTheme: 'ask'}. Alone, as the system is set.
export function watchTheme(apply) {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let told = null;
  let outer = null;
  try {
    outer = window.parent !== window ? window.parent.document.documentElement : null;
  } catch {
    outer = null;
  }
  const fromOuter = () => {
    if (!outer) return null;
    if (outer.classList.contains('dark-mode')) return true;
    return outer.classList.contains('light-mode') ? false : null;
  };
  const update = () => apply(told ?? fromOuter() ?? system.matches);
  system.addEventListener('change', update);
  window.addEventListener('message', event => {
    if (event.source === window.parent && typeof event.data?.caromDark === 'boolean') {
      told = event.data.caromDark;
      update();
    }
  });
  if (outer) new MutationObserver(update).observe(outer, { attributes: true, attributeFilter: ['class'] });
  if (window.parent !== window) window.parent.postMessage({ caromTheme: 'ask' }, '*');
  update();
}
