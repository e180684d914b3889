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
    // Doxygen's switch for keeping the tree in step with the page: two pictures without a text, of little use.
    document.getElementById("nav-sync")?.remove();
    const results = document.getElementById("MSearchResults");
    if (results) {
      results.title = "Search results";
    }
    const query = document.getElementById("MSearchField");
    if (query) {
      query.setAttribute("aria-label", "Search the site");
    }
  }

  // Doxygen lists "Classes" above a type whose inner types are private, and so not shown: such links lead nowhere.
  function dropDeadSummaries() {
    for (const link of document.querySelectorAll(".summary a[href^='#']")) {
      if (!document.getElementsByName(link.hash.slice(1)).length && !document.getElementById(link.hash.slice(1))) {
        link.remove();
      }
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

  // Players inside the page follow its theme: they ask once, and are told of every change.
  function tell(player) {
    const dark = document.documentElement.classList.contains("dark-mode");
    player.postMessage({ caromDark: dark }, "*");
  }

  window.addEventListener("message", function (event) {
    if (event.data && event.data.caromTheme === "ask") {
      tell(event.source);
    }
  });

  document.addEventListener("DOMContentLoaded", function () {
    markLandmarks();
    dropDeadSummaries();
    loadFormulas();
    const players = document.querySelectorAll("iframe.carom-player");
    new MutationObserver(function () {
      players.forEach((player) => tell(player.contentWindow));
    }).observe(document.documentElement, { attributeFilter: ["class"] });
  });
})();
