// What every page of the site does besides what Doxygen's own scripts do: the theme's buttons, landmarks for
// screen readers, and formulas. MathJax is 2 MB, so only pages that hold a formula load it.
"use strict";
(function () {
  const root = document.currentScript.dataset.root;

  DoxygenAwesomeDarkModeToggle.init();
  DoxygenAwesomeFragmentCopyButton.init();
  DoxygenAwesomeParagraphLink.init();
  DoxygenAwesomeInteractiveToc.init();

  function markLandmarks() {
    const content = document.getElementById("doc-content");
    if (content) {
      content.setAttribute("role", "main");
      content.tabIndex = -1;
    }
    const tree = document.getElementById("side-nav");
    if (tree) {
      tree.setAttribute("role", "navigation");
      tree.setAttribute("aria-label", "All pages");
    }
    const results = document.getElementById("MSearchResults");
    if (results) {
      results.title = "Search results";
    }
    const query = document.getElementById("MSearchField");
    if (query) {
      query.setAttribute("aria-label", "Search the site");
    }
  }

  // Unknown macros must show as errors, and nothing may be fetched later: hence the packages taken out.
  function loadFormulas() {
    if (!/\\\(|\\\[/.test(document.body.textContent)) {
      return;
    }
    window.MathJax = {
      tex: {
        inlineMath: [["\\(", "\\)"]],
        displayMath: [["\\[", "\\]"]],
        packages: { "[-]": ["noundefined", "autoload", "require"] },
      },
      svg: { fontCache: "global" },
      options: { ignoreHtmlClass: "fragment|search|tocreturn" },
    };
    const script = document.createElement("script");
    script.src = root + "mathjax/tex-svg.js";
    document.head.appendChild(script);
  }

  // Players inside the page follow the theme of the page.
  function tellPlayers() {
    const dark = document.documentElement.classList.contains("dark-mode");
    for (const frame of document.querySelectorAll("iframe.carom-player")) {
      frame.contentWindow.postMessage({ caromTheme: dark ? "dark" : "light" }, "*");
    }
  }

  document.addEventListener("DOMContentLoaded", function () {
    markLandmarks();
    loadFormulas();
    for (const frame of document.querySelectorAll("iframe.carom-player")) {
      frame.addEventListener("load", tellPlayers);
    }
    new MutationObserver(tellPlayers).observe(document.documentElement, { attributeFilter: ["class"] });
  });
})();
