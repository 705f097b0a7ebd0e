// Colours of regions and of heat maps, light and dark.
const dark = () => matchMedia("(prefers-color-scheme: dark)").matches;
const HUES = { sliding: [212, 190, 236, 168, 224], "stick-slip": [30, 46, 14, 340, 70], "at-rest": [0] };

function ofHsl(h, s, l) {
  const part = (n) => {
    const k = (n + h / 30) % 12;
    return Math.round(255 * (l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [part(0), part(8), part(4)];
}

/** Returns the colour of a class: from the hues of its regime, another one for each of its modes. */
export function classColour(name, number) {
  const regime = name.split(":")[0], hues = HUES[regime] ?? [0], saturation = regime === "at-rest" ? 0 : 0.55;
  const light = [0.84, 0.74, 0.79][Math.floor(number / hues.length) % 3];
  return ofHsl(hues[number % hues.length], saturation, dark() ? 1.06 - light : light);
}

// Colour maps by some of their colours: one from low to high, one with 0 in the middle.
const UPWARD = [[68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140], [40, 174, 128], [94, 201, 98], [173, 220, 48], [253, 231, 37]];
const BOTH = [[33, 84, 168], [86, 140, 203], [160, 196, 226], [240, 240, 238], [244, 188, 150], [219, 122, 82], [170, 54, 40]];

/** Returns the colour at a fraction of a map, 0 to 1. */
export function heatColour(part, both) {
  const table = both ? BOTH : UPWARD, place = Math.min(Math.max(part, 0), 1) * (table.length - 1), i = Math.min(Math.floor(place), table.length - 2);
  return table[i].map((low, k) => Math.round(low + (place - i) * (table[i + 1][k] - low)));
}
export const css = ([red, green, blue]) => `rgb(${red} ${green} ${blue})`;
