// A formula's text as MathML, for display; the core computes values.
const SPACE = "http://www.w3.org/1998/Math/MathML";
const GREEK = { alpha: "α", pi: "π" };
const TOKENS = /\s*([0-9.]+|[A-Za-z][A-Za-z0-9_.:]*|[-+*/^(),])/gy;

function node(tag, ...children) {
  const made = document.createElementNS(SPACE, tag);
  made.append(...children);
  return made;
}

const bracket = (sign) => {
  const made = node("mo", sign);
  made.setAttribute("stretchy", "false");
  return made;
};

function named(name) {
  const [, base, index] = name.match(/^(alpha|mstar|L_kin|[A-Za-z]+?)_?(0|1|2|T|start|end|switch|kin)?$/) ?? [null, name];
  if (name === "L_kin") return node("msub", node("mi", "L"), node("mi", "kin"));
  if (name === "mstar") return node("msup", node("mi", "m"), node("mo", "∗"));
  if (name === "dT") return node("mrow", node("mi", "ΔT"));
  const letter = node("mi", GREEK[base] ?? base);
  return index ? node("msub", letter, node(/[0-9]/.test(index) ? "mn" : "mi", index)) : letter;
}

/** Reads by recursive descent: a sum of products of powers. Each function returns a node, and whether it is a sum. */
class Reader {
  constructor(text) {
    this.tokens = [...text.matchAll(TOKENS)].map((match) => match[1]);
    this.at = 0;
  }
  next(...wanted) {
    return wanted.includes(this.tokens[this.at]) ? this.tokens[this.at++] : null;
  }
  sum() {
    const parts = [this.product()];
    for (let sign; (sign = this.next("+", "-")); ) parts.push(node("mo", sign === "-" ? "−" : "+"), this.product());
    return parts.length > 1 ? Object.assign(node("mrow", ...parts), { isSum: true }) : parts[0];
  }
  product() {
    if (this.next("-")) return Object.assign(node("mrow", node("mo", "−"), this.product()), { isSum: true });
    let above = [this.power()], below = [];
    for (let sign; (sign = this.next("*", "/")); ) {
      if (sign === "/") below.push(this.power());
      else if (below.length) [above, below] = [[fraction(above, below), this.power()], []];
      else above.push(this.power());
    }
    return below.length ? fraction(above, below) : joined(above);
  }
  power() {
    const base = this.value();
    return this.next("^") ? node("msup", around(base), this.next("-") ? node("mrow", node("mo", "−"), this.value()) : this.value()) : base;
  }
  value() {
    if (this.next("(")) {
      const inside = this.sum();
      this.next(")");
      return inside;
    }
    const token = this.tokens[this.at++] ?? "";
    if (/^[0-9.]/.test(token)) return node("mn", token);
    if (!this.next("(")) return named(token);
    const inside = [this.sum()];
    while (this.next(",")) inside.push(node("mo", ","), this.sum());
    this.next(")");
    return node("mrow", node("mi", token), node("mo", "("), ...inside, node("mo", ")"));
  }
}

const around = (one) => (one.isSum ? node("mrow", node("mo", "("), one, node("mo", ")")) : one);
const joined = (all) => (all.length === 1 ? all[0] : node("mrow", ...all.flatMap((one, i) => (i === 0 ? [around(one)] : [node("mo", "⁢"), around(one)]))));
const fraction = (above, below) => node("mfrac", joined(above), joined(below));

/** Returns the MathML of "QUANTITY = TEXT + O(T^n)". */
export function mathOf(formula) {
  const right = [new Reader(formula.text).sum()];
  if (formula.remainder > 0) right.push(node("mo", "+"), node("mi", "O"), bracket("("), node("msup", node("mi", "T"), node("mn", String(formula.remainder))), bracket(")"));
  const math = node("math", node("mrow", named(formula.quantity), node("mo", "="), ...right));
  math.setAttribute("display", "block");
  return math;
}
