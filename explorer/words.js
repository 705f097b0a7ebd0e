// Numbers and modes in words.
const DIRECTIONS = { "+": "forward", "-": "back", 0: "at rest" };

/** Returns a number for display: all digits of a double if `full`, else six. */
export function shown(x, full = false) {
  if (Number.isNaN(x)) return "none";
  return full ? String(x) : String(Number(x.toPrecision(6)));
}

function modeInWords(mode) {
  if (mode === "...") return "and so on";
  const [one, two] = [...mode].map((sign) => DIRECTIONS[sign]);
  return one === two ? `both ${one}` : `body 1 ${one}, body 2 ${two}`;
}

/** Returns "++ -+ ++ | ..." as sentences. */
export function modesInWords(modes) {
  return modes.split(" | ").map((phase, i) => {
    const words = phase.split(" ").filter(Boolean).map(modeInWords);
    return `${i === 0 ? "Extension" : "Contraction"}: ${words.join("; then ") || "nothing changes"}.`;
  });
}

export const REGIME_WORDS = {
  sliding: "Both bodies slide all the time.",
  "stick-slip": "A body sticks for part of the period.",
  "at-rest": "One body never moves.",
};
