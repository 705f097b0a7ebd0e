'use strict';
// What scripts/report/check_report.py asks in the page. Each function gives numbers or a list of complaints.
globalThis.audit = (() => {
  const channels = (colour) => {
    const [red, green, blue, alpha = 1] = colour.match(/[\d.]+/g).map(Number);
    return { red, green, blue, alpha };
  };
  const over = (top, below) => {
    const mix = (name) => top[name] * top.alpha + below[name] * (1 - top.alpha);
    return { red: mix('red'), green: mix('green'), blue: mix('blue'), alpha: 1 };
  };
  const background = (element) => {
    const own = channels(getComputedStyle(element).backgroundColor);
    if (own.alpha === 1) return own;
    return over(own, element.parentElement ? background(element.parentElement) : channels('rgb(255, 255, 255)'));
  };
  const luminance = ({ red, green, blue }) => {
    const linear = (value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
  };
  const contrast = (one, two) => {
    const [dark, light] = [luminance(one), luminance(two)].sort((a, b) => a - b);
    return (light + 0.05) / (dark + 0.05);
  };
  const named = (element) => {
    const place = element.closest('[id]');
    return `<${element.localName}> "${element.textContent.trim().slice(0, 40)}"${place ? ` in #${place.id}` : ''}`;
  };
  // Elements that hold text of their own and are seen; of those that look alike in the same kind of place, one.
  const withText = (selector) => {
    const seen = new Map();
    for (const element of document.querySelectorAll(selector)) {
      const own = Array.from(element.childNodes).some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim() !== '');
      if (!own || element.getClientRects().length === 0) continue;
      const style = getComputedStyle(element);
      const look = [style.color, style.fill, style.fontSize, element.closest('figure, table, pre, .controls')?.className,
        element.localName,
        element.parentElement.localName, element.parentElement.className, JSON.stringify(background(element))].join();
      if (!seen.has(look)) seen.set(look, element);
    }
    return [...seen.values()];
  };
  const texts = (least, leastInTables) => {
    const bad = [];
    for (const element of withText('body *:not(svg, svg *, script, option)')) {
      const style = getComputedStyle(element);
      const ratio = contrast(over(channels(style.color), background(element)), background(element));
      if (ratio < 4.5) bad.push(`contrast ${ratio.toFixed(2)} of ${named(element)}`);
      const wanted = element.closest('table') ? leastInTables : least;
      if (parseFloat(style.fontSize) < wanted && !element.closest('sup, sub, math')) {
        bad.push(`font size ${style.fontSize} of ${named(element)}`);
      }
    }
    return bad;
  };
  // In plots: text is legible on the ground and on the colours of regions, lines are seen; exponents may be smaller.
  const plotTexts = (least) => {
    const bad = [];
    for (const element of withText('.plot svg text, .plot svg tspan')) {
      const style = getComputedStyle(element);
      const ratio = contrast(channels(style.fill), background(element));
      if (ratio < 4.5) bad.push(`contrast ${ratio.toFixed(2)} of ${named(element)}`);
      const size = parseFloat(style.fontSize) * Math.hypot(element.getScreenCTM().a, element.getScreenCTM().b);
      const raised = /[1-9]/.test(element.getAttribute('dy') || '');
      if (size < least && !raised) bad.push(`font size ${size.toFixed(1)} of ${named(element)}`);
    }
    return bad;
  };
  const colours = () => {
    const probe = document.body.appendChild(document.createElement('span'));
    const resolved = (name) => {
      probe.style.color = `var(--${name})`;
      return channels(getComputedStyle(probe).color);
    };
    const bad = [];
    const demand = (one, two, least) => {
      const ratio = contrast(resolved(one), resolved(two));
      if (ratio < least) bad.push(`contrast ${ratio.toFixed(2)} of --${one} on --${two}`);
    };
    for (const line of ['blue', 'red', 'green', 'gold', 'purple', 'grey', 'faint']) demand(line, 'ground', 3);
    for (const region of ['sliding', 'stick-slip', 'at-rest']) demand('ink', region, 4.5);
    probe.remove();
    return bad;
  };
  const pictures = () => Array.from(document.querySelectorAll('figure .plot svg'), (svg) => {
    const box = svg.getBoundingClientRect();
    const frame = svg.closest('.plot').getBoundingClientRect();
    const width = Math.min(box.right, frame.right) - box.left;
    return { name: svg.getAttribute('aria-label') || '', width: box.width, height: box.height, cut: box.right > frame.right + 1,
      box: [box.left + scrollX, box.top + scrollY, width, box.height] };
  });
  // How many colours a picture has, and the share of the most common one.
  const painted = async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    canvas.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(canvas.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    const counts = new Map();
    for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) || 0) + 1);
    return { colours: counts.size, common: Math.max(...counts.values()) / pixels.length };
  };
  const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const open = async () => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    for (const box of document.querySelectorAll('.enlarge input')) box.checked = true;
    await drawn();
  };
  // Words of a table that reach out of their cell, and formulas that stand alone without a left side
  const clipped = () => {
    const bad = [];
    const ruler = new OffscreenCanvas(1, 1).getContext('2d');
    for (const cell of document.querySelectorAll('.claims tr:not(.claim) :is(td, th)')) {
      const room = cell.clientWidth - parseFloat(getComputedStyle(cell).paddingRight);
      const widths = Array.from(cell.querySelectorAll('mtext'), (part) => { // a formula cuts off what its cell has no room for
        ruler.font = getComputedStyle(part).font;
        return ruler.measureText(part.textContent).width;
      });
      if (cell.getClientRects().length > 0 && Math.max(...widths) > room + 2) bad.push(`clipped: ${named(cell)}`);
    }
    for (const formula of document.querySelectorAll('.display math')) {
      if (!formula.textContent.includes('=')) bad.push(`a formula without a left side: ${named(formula)}`);
    }
    return bad.slice(0, 5);
  };
  const width = () => [document.documentElement.scrollWidth, innerWidth];
  // Verdict and conditions of every row of a table of claims are within the window, and formulas are drawn.
  const claimTables = () => {
    const bad = [];
    for (const cell of document.querySelectorAll('.claims tbody tr:not(.claim) :is(td:nth-child(1), td:nth-child(3))')) {
      const box = cell.getBoundingClientRect();
      const inside = box.width > 20 && box.left >= 0 && box.right <= innerWidth && cell.scrollWidth <= Math.ceil(box.width);
      if (!inside) bad.push(`out of sight: ${named(cell)}`);
    }
    for (const formula of document.querySelectorAll('math')) {
      const box = formula.getBoundingClientRect();
      if (box.width < 3 || box.height < 5) bad.push(`a formula of ${box.width} x ${box.height} px: ${named(formula)}`);
    }
    return bad.slice(0, 5);
  };
  // Pictures and captions that lie over one another, and texts of a plot that do
  const overlaps = () => {
    const over = (one, two) => Math.min(one.bottom, two.bottom) - Math.max(one.top, two.top) > 1
      && Math.min(one.right, two.right) - Math.max(one.left, two.left) > 1;
    const boxes = (parts) => Array.from(parts, (part) => [part, part.getBoundingClientRect()]);
    const figures = boxes(document.querySelectorAll('figure .plot svg, figcaption'));
    const bad = figures.slice(1).filter(([, box], i) => over(box, figures[i][1])).map(([part]) => part.getAttribute('aria-label') || named(part));
    for (const svg of document.querySelectorAll('figure .plot svg')) {
      const texts = boxes(svg.querySelectorAll('text'));
      texts.forEach(([part, box], i) => texts.slice(0, i).some(([, before]) => over(box, before)) && bad.push(named(part)));
    }
    return bad.map((what) => `lies over what is before it: ${what}`);
  };
  // How far each body of the crawlers goes, back and forth, in a second, in pixels
  const moved = async () => {
    const bodies = Array.from(document.querySelectorAll('.body1, .body2'));
    const places = () => bodies.map((body) => new DOMMatrix(getComputedStyle(body).transform).e);
    const paths = bodies.map(() => 0);
    await drawn();
    for (let before = places(), i = 0; i < 4; i++) {
      await new Promise((done) => setTimeout(done, 250));
      const now = places();
      now.forEach((place, body) => { paths[body] += Math.abs(place - before[body]); });
      before = now;
    }
    return paths;
  };
  // Follows a link to the table of claims; gives what is shown, what should be, and what the line above the table says.
  const filtered = (selector) => {
    const link = document.querySelector(selector);
    link.click();
    const rows = Array.from(document.querySelectorAll('#claims-table tr[data-verdict]'));
    const { verdict, scope } = link.dataset;
    return { shown: rows.filter((row) => row.getClientRects().length > 0).length,
      wanted: rows.filter((row) => row.dataset.verdict === verdict && row.dataset.scope === scope).length,
      said: Number(link.textContent.match(/\d+/)[0]),
      says: document.querySelector('.controls output').textContent };
  };
  return { texts, plotTexts, colours, pictures, painted, open, width, clipped, claimTables, overlaps, moved, filtered };
})();
