// SPDX-License-Identifier: BSD-2-Clause
// Draws the page from its data. Texts become text nodes and attributes only; nothing is ever read as markup.
'use strict';
(function () {
  const COLORS = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => 'var(--c' + i + ')');  // Of the style: light ones where it is dark.
  const DASHES = ['', '6 3', '2 3', '8 3 2 3'];
  const runs = JSON.parse(document.getElementById('data').textContent);
  const app = document.getElementById('app');
  const NS = 'http://www.w3.org/2000/svg';

  // Marks that turn the direction of text would turn what stands behind a name, too.
  const plain = (text) => String(text).replace(/[\u202a-\u202e\u2066-\u2069]/g, '\ufffd');

  function make(space, name, attributes, children) {
    const node = space ? document.createElementNS(space, name) : document.createElement(name);
    for (const key of Object.keys(attributes || {})) {
      if (key === 'on') for (const event of Object.keys(attributes.on)) node.addEventListener(event, attributes.on[event]);
      else if (attributes[key] !== null && attributes[key] !== undefined) node.setAttribute(key, attributes[key]);
    }
    for (const child of [].concat(children === undefined ? [] : children))
      if (child !== null) node.appendChild(typeof child === 'object' ? child : document.createTextNode(plain(child)));
    return node;
  }
  const h = (name, attributes, children) => make(null, name, attributes, children);
  const s = (name, attributes, children) => make(NS, name, attributes, children);
  const seconds = (t) => t.toFixed(1) + ' s';
  const short = (x) => (x === null || x === undefined ? '' : typeof x === 'number' ? String(+x.toPrecision(4)) : String(x));
  const color = (i) => COLORS[i % COLORS.length];
  const dash = (i) => DASHES[Math.floor(i / COLORS.length) % DASHES.length];

  // Agents of a team share its colour, the one that it is called after if there is one; dashes tell them apart. Without
  // teams each agent has a colour of its own.
  const NAMED = { blue: 0, red: 1, green: 2, purple: 3, orange: 4 };
  function paints(run) {
    const teams = [...new Set(run.agents.map((agent) => agent.team || ''))];
    if (teams.length < 2 || teams.length > COLORS.length) return run.agents.map((_, i) => ({ color: color(i), dash: dash(i) }));
    const taken = new Set(teams.filter((team) => Object.hasOwn(NAMED, team)).map((team) => NAMED[team]));
    const free = COLORS.map((_, i) => i).filter((i) => !taken.has(i)), of = {}, members = {};
    teams.forEach((team) => { of[team] = Object.hasOwn(NAMED, team) ? NAMED[team] : free.shift(); members[team] = 0; });
    return run.agents.map((agent) => ({ color: color(of[agent.team || '']), dash: DASHES[members[agent.team || '']++ % DASHES.length] }));
  }

  // Where a name goes beside a dot: where it covers no other name and no dot, if there is such a place.
  const SIDES = [[9, 4, 'start'], [-9, 4, 'end'], [9, 17, 'start'], [9, -9, 'start'], [-9, 17, 'end'], [-9, -9, 'end'], [9, 30, 'start'], [9, -22, 'start']];
  function placeNames(places) {
    const boxes = places.map((place) => [place.x - 7, place.y - 7, place.x + 7, place.y + 7]);
    places.forEach((place) => {
      const width = 7.2 * place.name.length;
      const boxAt = ([dx, dy, anchor]) => {
        const left = place.x + dx - (anchor === 'end' ? width : 0);
        return [left, place.y + dy - 11, left + width, place.y + dy + 3];
      };
      const isFree = (box) => boxes.every((other, i) => places[i] === place || box[2] < other[0] || box[0] > other[2] || box[3] < other[1] || box[1] > other[3]);
      const side = SIDES.find((each) => isFree(boxAt(each))) || SIDES[0];
      place.text.setAttribute('x', side[0]);
      place.text.setAttribute('y', side[1]);
      place.text.setAttribute('text-anchor', side[2]);
      boxes.push(boxAt(side));
    });
  }

  function section(title, children, id) {
    const head = h('h2', { id: id + '-head' }, title);
    return h('section', { 'aria-labelledby': id + '-head', id: id }, [head].concat(children));
  }

  /// A table whose columns sort by a click or by Enter.
  function table(columns, rows, caption) {
    const body = h('tbody');
    let order = rows.map((_, i) => i), by = -1, up = true;
    const isNumber = columns.map((_, c) => rows.some((row) => typeof row[c] === 'number') && rows.every((row) => typeof row[c] === 'number' || row[c] === ''));
    const heads = columns.map((name, c) => h('th', { scope: 'col', 'aria-sort': 'none', class: isNumber[c] ? 'number' : null },
      h('button', { type: 'button', on: { click: () => sort(c) } }, name)));
    function fill() {
      body.textContent = '';
      for (const i of order.slice(0, 2000)) body.appendChild(h('tr', {}, rows[i].map((cell, c) =>
        h('td', { class: isNumber[c] ? 'number' : null }, cell !== null && typeof cell === 'object' ? cell : short(cell)))));
    }
    function sort(c) {
      up = by === c ? !up : true;
      by = c;
      const text = (cell) => (cell !== null && typeof cell === 'object' ? cell.textContent : cell);
      order.sort((a, b) => {
        const x = text(rows[a][c]), y = text(rows[b][c]);
        const less = typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y), undefined, { numeric: true });
        return (up ? less : -less) || a - b;
      });
      heads.forEach((head, i) => head.setAttribute('aria-sort', i === c ? (up ? 'ascending' : 'descending') : 'none'));
      fill();
    }
    fill();
    return h('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption },
      h('table', {}, [h('caption', { class: 'quiet' }, caption + (rows.length > 2000 ? ' (the first 2000 of ' + rows.length + ')' : '')),
        h('thead', {}, h('tr', {}, heads)), body]));
  }

  function scale(low, high, from, to) {
    const span = high - low || 1;
    return (x) => from + (to - from) * (x - low) / span;
  }
  function ticks(low, high, count) {
    const raw = (high - low || 1) / count, power = Math.pow(10, Math.floor(Math.log10(raw)));
    const step = [1, 2, 5, 10].map((m) => m * power).find((m) => m >= raw);
    const list = [];
    for (let x = Math.ceil(low / step) * step; x <= high + 1e-9; x += step) list.push(+x.toFixed(9));
    return list;
  }
  /// A number on an axis, with the digits that tell it from its neighbours.
  function labelOf(v, list) {
    const step = list.length > 1 ? Math.abs(list[1] - list[0]) : 1;
    return String(+v.toFixed(Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(step))))));
  }

  /// Series come as differences, in cm and tenths of m/s.
  function unpack(run) {
    const series = { x: 100, z: 100, hp: 1, v: 10 };
    run.agents.forEach((agent) => Object.keys(series).forEach((key) => {
      let sum = 0;
      if (agent[key]) agent[key] = agent[key].map((difference) => (sum += difference) / series[key]);
    }));
    run.unpacked = true;
  }

  // A run.
  function runPage(run) {
    if (!run.unpacked) unpack(run);
    const moved = [];
    let now = 0;
    const end = Math.max(run.seconds, 0.1);
    const slider = h('input', { type: 'range', min: 0, max: end, step: 0.1, value: 0, 'aria-label': 'Time', id: 'slider' });
    const shown = h('output', { for: 'slider' }, seconds(0));
    const play = h('button', { type: 'button', id: 'play' }, 'Play');
    let timer = null;
    function go(t) {
      now = Math.min(end, Math.max(0, t));
      slider.value = now;
      shown.textContent = seconds(now);
      moved.forEach((f) => f(now));
    }
    function stop() {
      clearInterval(timer);
      timer = null;
      play.textContent = 'Play';
    }
    slider.addEventListener('input', () => { stop(); go(+slider.value); });
    play.addEventListener('click', () => {
      if (timer) return stop();
      if (now >= end) go(0);
      play.textContent = 'Pause';
      timer = setInterval(() => { go(now + 0.1); if (now >= end) stop(); }, 100);
    });
    const jump = (t, text) => h('button', { type: 'button', class: 'link', on: { click: () => { stop(); go(t); } } }, text);
    const reasons = (list) => (list && list.length ? h('details', {}, [h('summary', {}, 'Why'), h('pre', {}, list.join('\n'))]) : null);
    const marks = { passed: ['✓', 'good'], failed: ['✗', 'bad'], moment: ['•', 'moment'], 'over seeds': ['○', 'quiet'] };

    const checks = run.checks.length ? section('Checks', h('ul', { class: 'plain' }, run.checks.map((check) => h('li', {}, [
      h('span', { class: marks[check.mark][1] }, marks[check.mark][0] + ' ' + check.mark + ' '),
      jump(check.time, check.text + ' (' + check.time_text + ')'), reasons(check.reasons)]))), 'checks') : null;
    const moments = run.moments.length ? section('Key moments', h('ul', { class: 'plain' }, run.moments.map((moment) => h('li', {}, [
      jump(moment.time, moment.time_text + '  ' + moment.text), reasons(moment.reasons)]))), 'moments') : null;
    const body = [header(run), h('div', { class: 'bar' }, [play, slider, shown]),
      h('div', { class: 'two' }, [h('div', {}, [checks, moments]), section('Map', map(run, moved), 'map')]),
      section('Timeline', timeline(run, moved, go), 'timeline'),
      section('Numbers', numbers(run, moved), 'numbers'), messages(run, jump), rules(run), files(run), about(run)];
    setTimeout(() => go(0), 0);
    return body;
  }

  function header(run) {
    const good = run.passed === true, bad = run.passed === false;
    const root = document.documentElement;
    return h('header', {}, [h('div', {}, [h('h1', {}, run.title),
      h('div', { class: 'verdict ' + (good ? 'good' : bad ? 'bad' : 'quiet'), id: 'verdict' }, run.verdict),
      h('div', { class: 'quiet' }, ['See it: ', h('code', {}, run.command)])]),
      h('button', { type: 'button', id: 'theme', on: { click: () => {
        const dark = root.getAttribute('data-theme') ? root.getAttribute('data-theme') === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
        root.setAttribute('data-theme', dark ? 'light' : 'dark');
      } } }, 'Light or dark')]);
  }

  function indexAt(times, t) {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= t + 1e-6) low = middle; else high = middle - 1;
    }
    return low;
  }

  function map(run, moved) {
    const xs = [], zs = [];
    run.agents.forEach((agent) => { if (agent.x) { agent.x.forEach((x) => xs.push(x)); agent.z.forEach((z) => zs.push(z)); } });
    run.waypoints.concat(run.regions).forEach((place) => { xs.push(place.x); zs.push(place.z); });
    if (!xs.length) return h('p', { class: 'quiet' }, 'Nobody has a body here.');
    const least = (list) => list.reduce((a, b) => Math.min(a, b), Infinity), most = (list) => list.reduce((a, b) => Math.max(a, b), -Infinity);
    let x0 = least(xs) - 3, x1 = most(xs) + 3, z0 = least(zs) - 3, z1 = most(zs) + 3;
    const side = Math.max(x1 - x0, z1 - z0, 8), w = 640;
    const cx = (x0 + x1) / 2, cz = (z0 + z1) / 2;
    x0 = cx - side / 2; z0 = cz - side / 2;
    const m = (d) => d / side * w, X = (x) => m(x - x0), Z = (z) => m(z - z0);
    const svg = s('svg', { viewBox: '0 0 ' + w + ' ' + w, role: 'img', 'aria-label': 'Map of ' + run.agents.length + ' agents and their ways', id: 'ways' });
    run.things.forEach((thing) => svg.appendChild(thing.round
      ? s('circle', { cx: X(thing.x), cy: Z(thing.z), r: m(thing.w / 2), fill: 'var(--line)' })
      : s('rect', { x: X(thing.x - thing.w / 2), y: Z(thing.z - thing.d / 2), width: m(thing.w), height: m(thing.d), fill: 'var(--line)', transform: 'rotate(' + (-thing.turn) + ' ' + X(thing.x) + ' ' + Z(thing.z) + ')' })));
    run.regions.forEach((place) => {
      svg.appendChild(place.hx > 0 ? s('rect', { x: X(place.x - place.hx), y: Z(place.z - place.hz), width: m(2 * place.hx), height: m(2 * place.hz), fill: 'none', stroke: 'var(--quiet)', 'stroke-dasharray': '4 4' })
        : s('circle', { cx: X(place.x), cy: Z(place.z), r: m(place.r), fill: 'none', stroke: 'var(--quiet)', 'stroke-dasharray': '4 4' }));
      svg.appendChild(s('text', { x: X(place.x), y: Z(place.z) - 4, 'text-anchor': 'middle', class: 'quiet' }, place.name));
    });
    run.waypoints.forEach((place) => {
      svg.appendChild(s('circle', { cx: X(place.x), cy: Z(place.z), r: 5, fill: 'none', stroke: 'var(--quiet)' }));
      svg.appendChild(s('text', { x: X(place.x) + 8, y: Z(place.z) + 4, class: 'quiet' }, place.name));
    });
    const paint = paints(run);
    const dots = run.agents.map((agent, i) => {
      if (!agent.x) return null;
      let path = '', lastX = null, lastZ = null;
      agent.x.forEach((x, k) => {
        const z = agent.z[k], last = k === agent.x.length - 1;
        if (lastX !== null && !last && Math.hypot(x - lastX, z - lastZ) < side / 500) return;
        path += (lastX === null ? 'M' : 'L') + X(x).toFixed(1) + ' ' + Z(z).toFixed(1);
        lastX = x; lastZ = z;
      });
      svg.appendChild(s('path', { d: path, fill: 'none', stroke: paint[i].color, 'stroke-width': 1.5, 'stroke-dasharray': paint[i].dash, 'stroke-opacity': 0.55 }));
      const text = s('text', { x: 9, y: 4 }, agent.name);
      const group = s('g', {}, [s('circle', { r: 6, fill: paint[i].color, stroke: 'var(--card)', 'stroke-width': 1.5 }), text]);
      svg.appendChild(group);
      return { group: group, text: text, name: agent.name, x: 0, y: 0 };
    });
    moved.push((t) => {
      const k = indexAt(run.times, t);
      run.agents.forEach((agent, i) => {
        if (!dots[i]) return;
        const at = Math.max(0, Math.min(agent.x.length - 1, k - agent.from));
        const next = Math.min(agent.x.length - 1, at + 1), t0 = run.times[at + agent.from], t1 = run.times[next + agent.from];
        const share = t1 > t0 ? Math.min(1, Math.max(0, (t - t0) / (t1 - t0))) : 0;
        dots[i].x = X(agent.x[at] + share * (agent.x[next] - agent.x[at]));
        dots[i].y = Z(agent.z[at] + share * (agent.z[next] - agent.z[at]));
        dots[i].group.setAttribute('transform', 'translate(' + dots[i].x + ' ' + dots[i].y + ')');
        dots[i].group.setAttribute('opacity', agent.hp[at] > 0 ? 1 : 0.35);
      });
      placeNames(dots.filter((dot) => dot !== null));
    });
    return h('figure', {}, [h('figcaption', {}, 'Everybody\'s way, seen from above, ' + Math.round(side) + ' m wide. The dots stand where they are at the moment of the slider.'), svg]);
  }

  function timeline(run, moved, go) {
    const w = 1200, left = 110, row = 30, height = run.agents.length * row + 24;
    const X = scale(0, run.seconds || 1, left, w - 24);
    const svg = s('svg', { viewBox: '0 0 ' + w + ' ' + height, role: 'img', 'aria-label': 'Operators and events of each agent over time', style: 'min-width:720px', id: 'spans' });
    ticks(0, run.seconds || 1, 10).forEach((t) => {
      svg.appendChild(s('line', { x1: X(t), x2: X(t), y1: 0, y2: height - 18, stroke: 'var(--line)' }));
      svg.appendChild(s('text', { x: X(t), y: height - 4, 'text-anchor': 'middle', class: 'quiet' }, t + ' s'));
    });
    const names = [];
    run.agents.forEach((agent, i) => svg.appendChild(s('text', { x: 4, y: i * row + 18 }, agent.name.length > 14 ? agent.name.slice(0, 13) + '…' : agent.name)));
    run.spans.forEach((span) => {
      const name = span[3], x = X(span[1]), width = Math.max(1, X(span[2]) - x);
      let number = names.indexOf(name);
      if (number < 0) number = names.push(name) - 1;
      const bar = s('g', {}, [s('title', {}, run.agents[span[0]].name + ': ' + name + ', ' + seconds(span[1]) + ' to ' + seconds(span[2])),
        s('rect', { x: x, y: span[0] * row + 5, width: width, height: 18, fill: color(number), 'fill-opacity': 0.35, stroke: color(number), 'stroke-dasharray': dash(number) })]);
      if (width > 7 * name.length + 6) bar.appendChild(s('text', { x: x + 4, y: span[0] * row + 18 }, name));
      svg.appendChild(bar);
    });
    const place = {};
    run.agents.forEach((agent, i) => { place[agent.name] = i; });
    const drawn = new Set();
    run.events.forEach((event) => {
      if (!(event.a in place) || event.k === 'command' || event.k === 'print') return;
      // Of equal triangles one over the other one is enough.
      const spot = event.a + '/' + event.k + '/' + Math.round(X(event.t));
      if (drawn.has(spot)) return;
      drawn.add(spot);
      const fill = event.k === 'problem' || event.k === 'gap' || event.k === 'impasse' ? 'var(--bad)' : event.k === 'message' ? 'var(--mark)' : 'var(--text)';
      const x = X(event.t), y = place[event.a] * row + 26;
      svg.appendChild(s('path', { d: 'M' + (x - 3) + ' ' + y + 'L' + (x + 3) + ' ' + y + 'L' + x + ' ' + (y - 5) + 'Z', fill: fill }, s('title', {}, seconds(event.t) + ' ' + event.k + ': ' + event.text)));
    });
    const line = s('line', { y1: 0, y2: height - 18, stroke: 'var(--accent)', 'stroke-width': 2 });
    svg.appendChild(line);
    svg.addEventListener('click', (event) => {
      const box = svg.getBoundingClientRect();
      go(((event.clientX - box.left) / box.width * w - left) / (w - 24 - left) * run.seconds);
    });
    moved.push((t) => { line.setAttribute('x1', X(t)); line.setAttribute('x2', X(t)); });
    const rows = run.spans.map((span) => [run.agents[span[0]].name, span[3], span[1], span[2]]);
    const events = run.events.map((event) => [event.t, event.a, event.k, event.text]);
    const thinned = run.thinned.map((text) => h('p', { class: 'quiet' }, text));
    return [h('figure', {}, [h('figcaption', {}, 'Bars are selected operators; triangles are impasses, messages and other events. A click moves the slider.'), svg])].concat(thinned, [
      h('details', {}, [h('summary', {}, 'Operators as table'), table(['agent', 'operator', 'from', 'to'], rows, 'Operators')]),
      h('details', {}, [h('summary', {}, 'Events as table'), table(['time', 'agent', 'kind', 'what'], events, 'Events')])]);
  }

  function plot(run, key, title, moved) {
    const w = 560, height = 180, left = 40;
    let high = 0;
    run.agents.forEach((agent) => (agent[key] || []).forEach((v) => { high = Math.max(high, v); }));
    const X = scale(0, run.seconds || 1, left, w - 24), Y = scale(0, high || 1, height - 22, 8);
    const svg = s('svg', { viewBox: '0 0 ' + w + ' ' + height, role: 'img', 'aria-label': title + ' over time' });
    ticks(0, high || 1, 4).forEach((v) => {
      svg.appendChild(s('line', { x1: left, x2: w - 24, y1: Y(v), y2: Y(v), stroke: 'var(--line)' }));
      svg.appendChild(s('text', { x: left - 4, y: Y(v) + 4, 'text-anchor': 'end', class: 'quiet' }, short(v)));
    });
    ticks(0, run.seconds || 1, 6).forEach((t) => svg.appendChild(s('text', { x: X(t), y: height - 4, 'text-anchor': 'middle', class: 'quiet' }, t + ' s')));
    const paint = paints(run);
    run.agents.forEach((agent, i) => {
      if (!agent[key]) return;
      const step = Math.max(1, Math.floor(agent[key].length / 600));
      let path = '';
      agent[key].forEach((v, k) => { if (k % step === 0) path += (path ? 'L' : 'M') + X(run.times[k + agent.from]).toFixed(1) + ' ' + Y(v).toFixed(1); });
      svg.appendChild(s('path', { d: path, fill: 'none', stroke: paint[i].color, 'stroke-dasharray': paint[i].dash }, s('title', {}, agent.name)));
    });
    const line = s('line', { y1: 8, y2: height - 22, stroke: 'var(--accent)' });
    svg.appendChild(line);
    moved.push((t) => { line.setAttribute('x1', X(t)); line.setAttribute('x2', X(t)); });
    return h('figure', {}, [h('figcaption', {}, title), svg]);
  }

  function numbers(run, moved) {
    const rows = run.agents.map((agent) => [agent.name, agent.team, agent.distance, agent.health, agent.damage, agent.rounds, agent.alive ? 'yes' : 'no']);
    return [h('div', { class: 'even' }, [plot(run, 'v', 'Speed, m/s', moved), plot(run, 'hp', 'Health', moved)]),
      table(['agent', 'team', 'metres walked', 'health', 'health lost', 'rounds', 'alive'], rows, 'Each agent at the end')];
  }

  function messages(run, jump) {
    const list = run.events.filter((event) => event.k === 'message' || event.k === 'print');
    if (!list.length) return null;
    return section('Messages', table(['time', 'agent', 'what'], list.map((event) => [jump(event.t, seconds(event.t)), event.a, event.text]), 'What agents said and printed'), 'messages');
  }

  function rules(run) {
    const rows = [];
    run.agents.forEach((agent) => (agent.rules || []).forEach((rule) => rows.push([agent.name, rule.name, rule.firings, rule.firings ? '' : 'never fired' + (rule.stops ? '; stops at ' + rule.stops : ''), rule.file || ''])));
    return rows.length ? section('Rules', table(['agent', 'rule', 'fired', 'why never', 'where'], rows, 'What each agent\'s rules did'), 'rules') : null;
  }

  function files(run) {
    if (!run.files.length) return null;
    return section('Files', run.files.map((file) => h('details', {}, [h('summary', {}, file.name), h('pre', { tabindex: '0' }, file.text)])), 'files');
  }

  function about(run) {
    const lines = ['Scenario ' + run.scenario + ', seed ' + run.seed + ', ' + seconds(run.seconds) + ', build ' + run.build + '.',
      run.same ? 'The run was simulated again for this page and came to the recorded state.' : 'The run was simulated again for this page and did NOT come to the recorded state: files or the program have changed.'].concat(run.warnings);
    return section('About', lines.map((line) => h('p', { class: 'quiet' }, line)), 'about');
  }

  // A sweep.
  function strip(metric, names) {
    const all = [].concat.apply([], metric.variants.map((v) => v.values || []));
    const w = 560, left = 120, row = 34, height = names.length * row + 26;
    const low = all.reduce((a, b) => Math.min(a, b), Infinity), high = all.reduce((a, b) => Math.max(a, b), -Infinity);
    const X = scale(low, high, left, w - 36);
    const svg = s('svg', { viewBox: '0 0 ' + w + ' ' + height, role: 'img', 'aria-label': 'Distribution of ' + metric.name });
    const marks = ticks(low, high, 5);
    marks.forEach((v) => {
      svg.appendChild(s('line', { x1: X(v), x2: X(v), y1: 0, y2: height - 20, stroke: 'var(--line)' }));
      svg.appendChild(s('text', { x: X(v), y: height - 5, 'text-anchor': 'middle', class: 'quiet' }, labelOf(v, marks)));
    });
    metric.variants.forEach((v, i) => {
      svg.appendChild(s('text', { x: 4, y: i * row + 20 }, names[i].length > 16 ? names[i].slice(0, 15) + '…' : names[i]));
      const values = (v.values || []).slice();
      if (!values.length) return;
      if (values.length <= 200) {
        values.forEach((x, k) => svg.appendChild(s('circle', { cx: X(x), cy: i * row + 16 + ((k * 7) % 11) - 5, r: 2, fill: color(i), 'fill-opacity': 0.5 })));
      } else {
        values.sort((a, b) => a - b);
        const at = (q) => X(values[Math.floor(q * (values.length - 1))]);
        svg.appendChild(s('line', { x1: at(0.05), x2: at(0.95), y1: i * row + 16, y2: i * row + 16, stroke: color(i) }));
        svg.appendChild(s('rect', { x: at(0.25), y: i * row + 8, width: Math.max(1, at(0.75) - at(0.25)), height: 16, fill: color(i), 'fill-opacity': 0.3, stroke: color(i) }));
      }
      svg.appendChild(s('line', { x1: X(v.low), x2: X(v.high), y1: i * row + 28, y2: i * row + 28, stroke: color(i), 'stroke-width': 3 }));
      svg.appendChild(s('circle', { cx: X(v.mean), cy: i * row + 28, r: 3.5, fill: color(i) }, s('title', {}, 'mean ' + short(v.mean) + ', 95 %: ' + short(v.low) + ' to ' + short(v.high))));
    });
    return h('figure', {}, [h('figcaption', {}, metric.name + ': each run, with the mean and its 95 % interval below'), svg]);
  }

  // The agents of a tournament: what they have reached, and how sure their ratings are.
  function standings(agents) {
    const row = 26, height = row * agents.length + 30, low = Math.min(...agents.map((a) => a.low)), high = Math.max(...agents.map((a) => a.high));
    const X = scale(low, high, 140, 620), marks = ticks(low, high, 5);
    const svg = s('svg', { viewBox: '0 0 640 ' + height, role: 'img', 'aria-label': 'Ratings with their 95 % intervals' });
    marks.forEach((v) => {
      svg.appendChild(s('line', { x1: X(v), x2: X(v), y1: 0, y2: height - 20, stroke: 'var(--line)' }));
      svg.appendChild(s('text', { x: X(v), y: height - 5, 'text-anchor': 'middle', class: 'quiet' }, labelOf(v, marks)));
    });
    agents.forEach((a, i) => {
      const y = i * row + 14;
      svg.appendChild(s('text', { x: 4, y: y + 4 }, a.agent.length > 18 ? a.agent.slice(0, 17) + '…' : a.agent));
      svg.appendChild(s('line', { x1: X(a.low), x2: X(a.high), y1: y, y2: y, stroke: color(i), 'stroke-width': 3 }));
      svg.appendChild(s('circle', { cx: X(a.rating), cy: y, r: 4.5, fill: color(i) }, s('title', {}, a.agent + ': ' + a.rating + ' (95 %: ' + a.low + ' to ' + a.high + ')')));
    });
    const rows = agents.map((a) => [a.agent, a.rating, a.low + ' to ' + a.high, a.games, a.won, a.drawn, a.lost, a.place, a.points]);
    return section('Standings', [table(['agent', 'rating', '95 %', 'games', 'won', 'drawn', 'lost', 'place', 'points per game'], rows, 'Best first'),
      h('figure', {}, [h('figcaption', {}, 'Ratings on Elo’s scale, with 95 % intervals from resampling the games'), svg])], 'standings');
  }

  function sweepPage(sweep) {
    const names = sweep.variants.map((v) => v.name);
    const percent = (x) => Math.round(100 * x) + ' %';
    const variants = sweep.variants.map((v) => [v.name, v.runs, v.broken, v.runs - v.judged, v.passed, v.judged ? percent(v.passed / v.judged) : '', percent(v.low) + ' to ' + percent(v.high)]);
    const checks = sweep.check_names.map((name, i) => [name].concat(sweep.variants.map((v) => v.checks[i].true + ' of ' + v.checks[i].of + ' (' + percent(v.checks[i].low) + ' to ' + percent(v.checks[i].high) + ')')));
    const differences = [];
    sweep.metrics.forEach((metric) => metric.differences.forEach((d) => differences.push([metric.name, d.variant, d.mean, d.low, d.high, d.pairs, d.low > 0 || d.high < 0 ? 'yes' : 'may be chance'])));
    return [header(sweep), sweep.standings ? standings(sweep.standings) : null, section('Variants', table(['variant', 'runs', 'crashed or hung', 'undecided', 'passed', 'share', '95 %'], variants, 'Runs of each variant'), 'variants'),
      checks.length ? section('Checks', table(['check'].concat(names), checks, 'How often each check was true, with 95 % intervals'), 'checks') : null,
      section('Distributions', h('div', { class: 'even' }, sweep.metrics.slice(0, 24).map((metric) => strip(metric, names))), 'distributions'),
      differences.length ? section('Differences from ' + names[0] + ', on equal seeds', table(['number', 'variant', 'mean difference', 'low', 'high', 'pairs', 'real'], differences, 'Paired differences with 95 % intervals'), 'differences') : null,
      sweep.outliers.length ? section('Seeds that stand out', table(['variant', 'seed', 'what', 'value', 'median', 'see it'], sweep.outliers.map((o) => [o.variant, o.seed, o.what, o.value, o.median, h('code', {}, o.command)]), 'Furthest from the median of their variant'), 'outliers') : null,
      sweep.failed.length ? section('Runs that broke', table(['variant', 'seed', 'outcome', 'why'], sweep.failed.map((f) => [f.variant, f.seed, f.outcome, f.error]), 'Crashed and hung runs'), 'failed') : null,
      section('All runs', table(sweep.columns, sweep.rows.map((row) => row.map((cell) => (typeof cell === 'boolean' ? (cell ? 'yes' : 'no') : cell))), 'All runs'), 'rows'),
      section('About', [h('p', { class: 'quiet' }, 'Build ' + sweep.build + '. Intervals of means: 10,000 bootstrap resamples; of rates: Wilson.')], 'about')];
  }

  function show(index) {
    const run = runs[index];
    app.textContent = '';
    const main = h('main');
    if (runs.length > 1) {
      const choice = h('select', { 'aria-label': 'Run', id: 'run', on: { change: () => show(+choice.value) } }, runs.map((each, i) => h('option', { value: i }, each.title + ': ' + each.verdict)));
      choice.value = index;
      main.appendChild(choice);
    }
    for (const part of run.kind === 'sweep' ? sweepPage(run) : runPage(run)) if (part) main.appendChild(part);
    app.appendChild(main);
  }
  // The run in 3D is a page of its own, with styles of its own.
  const scene = JSON.parse(document.getElementById('scene').textContent);
  if (scene !== '') {
    const frame = h('iframe', { title: 'The run in 3D', class: 'scene' });
    frame.srcdoc = scene;
    document.body.insertBefore(frame, app);
  }
  show(0);
})();
