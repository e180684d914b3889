// The diagrams of error against time, which the reader can question: every engine can be taken out and put back,
// every mark says what it is, and a table says who gets to which error for how much. The figures are those of
// window.caromFronts, which the suite `accuracy` has measured.
"use strict";
(function () {
  const kWidth = 860, kHeight = 520;
  const kLeft = 84, kRight = 16, kTop = 16, kBottom = 58;
  const kColors = { carom: "#d55e00", box3d: "#009e73", bullet: "#56b4e9", jolt: "#cc79a7", mujoco: "#785ef0",
    ode: "#967800" };

  function colorOf(engine) {
    const found = Object.keys(kColors).find((name) => engine.startsWith(name));
    return found ? kColors[found] : "#8c8c8c";
  }

  function isOurs(engine) {
    return engine.startsWith("carom");
  }

  function element(name, attributes, text) {
    const svg = ["svg", "g", "line", "path", "circle", "text", "title"].includes(name);
    const made = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes ?? {})) {
      made.setAttribute(key, value);
    }
    if (text !== undefined) {
      made.textContent = text;
    }
    return made;
  }

  function digits(number) {
    return String(Number(Number(number).toPrecision(3)));
  }

  // The points that no other beats, cheapest first.
  function frontOf(points) {
    const front = [];
    for (const point of [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1])) {
      if (!front.length || point[1] < front[front.length - 1][1]) {
        front.push(point);
      }
    }
    return front;
  }

  // From powers of ten to powers of ten, around all numbers.
  function axisOf(numbers, from, to, room) {
    const low = Math.floor(Math.log10(Math.min(...numbers)));
    const high = Math.ceil(Math.log10(Math.max(...numbers)) + room);
    const span = Math.max(1, high - low);
    const place = (number) => from + (Math.log10(number) - low) / span * (to - from);
    return { low, high: low + span, place };
  }

  function drawGrid(svg, x, y, axisName) {
    for (let power = x.low; power <= x.high; ++power) {
      const at = x.place(10 ** power);
      svg.append(element("line", { x1: at, x2: at, y1: kTop, y2: kHeight - kBottom, class: "grid" }));
      svg.append(element("text", { x: at, y: kHeight - kBottom + 18, "text-anchor": "middle" }, `1e${power}`));
    }
    const every = Math.ceil((y.high - y.low) / 12);
    for (let power = y.low; power <= y.high; power += every) {
      const at = y.place(10 ** power);
      svg.append(element("line", { x1: kLeft, x2: kWidth - kRight, y1: at, y2: at, class: "grid" }));
      svg.append(element("text", { x: kLeft - 6, y: at + 4, "text-anchor": "end" }, `1e${power}`));
    }
    svg.append(element("text", { x: (kLeft + kWidth - kRight) / 2, y: kHeight - 12, "text-anchor": "middle" },
      "processor time per simulated second [µs]"));
    const turned = { x: 0, y: 0, "text-anchor": "middle",
      transform: `translate(18 ${(kTop + kHeight - kBottom) / 2}) rotate(-90)` };
    svg.append(element("text", turned, axisName));
  }

  function drawEngine(svg, engine, points, x, y) {
    const color = colorOf(engine), ours = isOurs(engine);
    const group = element("g", { "data-engine": engine });
    const runs = points.filter((point) => point[1] !== null);
    if (runs.length > 1) {
      const way = runs.map((p, i) => `${i ? "L" : "M"}${x.place(p[0]).toFixed(1)} ${y.place(p[1]).toFixed(1)}`);
      group.append(element("path", { d: way.join(""), fill: "none", stroke: color, "stroke-width": ours ? 3 : 1.5,
        "stroke-dasharray": engine.includes("advance") ? "7 5" : "none" }));
    }
    for (const [cost, error] of points) {
      const failed = error === null;
      const at = [x.place(cost), failed ? kTop + 8 : y.place(error)];
      const mark = failed
        ? element("path", { d: `M${at[0] - 5} ${at[1] - 5}l10 10m0 -10l-10 10`, stroke: color, "stroke-width": 2 })
        : element("circle", { cx: at[0], cy: at[1], r: ours ? 5 : 4, fill: color });
      mark.append(element("title", {},
        `${engine}: ${digits(cost)} µs per simulated second, ${failed ? "failed" : "error " + digits(error)}`));
      group.append(mark);
    }
    svg.append(group);
  }

  function drawFront(svg, points, x, y) {
    const front = frontOf(points);
    if (!front.length) {
      return;
    }
    let way = "";
    front.forEach(([cost, error], i) => {
      const at = `${x.place(cost).toFixed(1)} ${y.place(error).toFixed(1)}`;
      way += i ? `H${at.split(" ")[0]}L${at}` : `M${at}`;
    });
    svg.append(element("path", { d: `${way}H${kWidth - kRight}`, class: "front" }));
  }

  function draw(place, name, question, hidden) {
    const engines = Object.entries(question.engines).filter(([engine]) => !hidden.has(engine));
    const all = engines.flatMap(([, points]) => points);
    const runs = all.filter((point) => point[1] !== null);
    place.replaceChildren();
    if (!runs.length) {
      place.append(element("p", {}, "No engine is chosen that has a run with an error."));
      return;
    }
    const svg = element("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img",
      "aria-label": `${name}: ${question.axis} over processor time, both logarithmic; see the table at equal error` });
    const x = axisOf(all.map((point) => point[0]), kLeft, kWidth - kRight, 0);
    const y = axisOf(runs.map((point) => point[1]), kHeight - kBottom, kTop, 1);
    drawGrid(svg, x, y, question.axis);
    drawFront(svg, engines.filter(([engine]) => !isOurs(engine)).flatMap(([, points]) =>
      points.filter((point) => point[1] !== null)), x, y);
    engines.sort(([a], [b]) => isOurs(a) - isOurs(b)).forEach(([engine, points]) =>
      drawEngine(svg, engine, points, x, y));
    place.append(svg);
  }

  function tableOf(question) {
    const table = element("table"), head = element("tr");
    for (const title of ["error", "best other engine", "its time [µs/s]", "Carom", "its time [µs/s]", "ratio"]) {
      head.append(element("th", {}, title));
    }
    table.append(head);
    for (const one of question.compared ?? []) {
      const row = element("tr");
      const reached = "ratio" in one;
      for (const text of [digits(one.error), one.best, digits(one.us_per_s), reached ? one.ours : "not reached",
        reached ? digits(one.ours_us_per_s) : "", reached ? digits(one.ratio) : ""]) {
        row.append(element("td", {}, text));
      }
      table.append(row);
    }
    return table;
  }

  // A line for each question: the least error of the others, and the one where Carom looks worst.
  function overviewOf(entries) {
    const table = element("table"), head = element("tr");
    for (const title of ["question", "least error of the others", "by", "ratio there", "worst ratio", "at the error"]) {
      head.append(element("th", {}, title));
    }
    table.append(head);
    for (const { name, figure, question } of entries) {
      const all = question.compared ?? [];
      if (!all.length) {
        continue;
      }
      const finest = all[all.length - 1];
      const worst = all.reduce((a, b) => ((b.ratio ?? 0) < (a.ratio ?? 0) ? b : a));
      const ratio = (one) => ("ratio" in one ? digits(one.ratio) : "not reached");
      const row = element("tr");
      for (const text of [`${name}: ${figure}`, digits(finest.error), finest.best, ratio(finest), ratio(worst),
        digits(worst.error)]) {
        row.append(element("td", {}, text));
      }
      table.append(row);
    }
    return table;
  }

  function start(place, records) {
    const entries = Object.entries(records).flatMap(([name, record]) =>
      Object.entries(record.questions).filter(([, question]) => question.engines).map(([figure, question]) =>
        ({ name, record, figure, question })));
    const choice = element("select", { id: "carom-fronts-choice" });
    entries.forEach(({ name, figure }, i) => choice.append(element("option", { value: i }, `${name}: ${figure}`)));
    const label = element("label", { for: "carom-fronts-choice" }, "Diagram: ");
    const title = element("p"), engines = element("p"), picture = element("div"), where = element("p");
    const table = element("details", { class: "carom-table" });
    const hidden = new Set();
    function show() {
      const { name, record, question } = entries[choice.value];
      title.textContent = record.title;
      where.textContent = record.where;
      engines.replaceChildren();
      for (const engine of Object.keys(question.engines)) {
        const box = element("input", { type: "checkbox" });
        box.checked = !hidden.has(engine);
        box.addEventListener("change", () => {
          box.checked ? hidden.delete(engine) : hidden.add(engine);
          draw(picture, name, question, hidden);
        });
        const one = element("label", { style: `color: ${colorOf(engine)}` });
        one.append(box, document.createTextNode(` ${engine} `));
        engines.append(one);
      }
      draw(picture, name, question, hidden);
      table.replaceChildren(element("summary", {}, "At equal error"), tableOf(question));
    }
    choice.addEventListener("change", show);
    place.replaceChildren(label, choice, title, engines, picture, where, table);
    document.getElementById("carom-fronts-overview")?.replaceChildren(overviewOf(entries));
    show();
  }

  document.addEventListener("DOMContentLoaded", function () {
    const place = document.getElementById("carom-fronts");
    if (place && window.caromFronts) {
      start(place, window.caromFronts);
    }
  });
})();
