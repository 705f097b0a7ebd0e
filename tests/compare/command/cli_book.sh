#!/bin/sh
# Books of formulas: claims --book and --formula, their proofs and exit codes; what is wrong with a book; and the formulas of a book by name in
# the other commands.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$root/tests/support/common.sh"

cat >mine.cfg <<'END'
formulas = (
  { name = "my_xC"; start = "steady"; of = "displacement"; claimed = 6;
    where = { mstar = "m1*m2/M"; slow = "(1 - alpha)^2*F2*m2"; };
    text = "(F1 - F2)*(2*alpha - 1)*L*mstar/(alpha^2*F1*m1 + slow)"; },
  { name = "equal"; start = "rest"; of = "dxC"; claimed = "equality"; when = [ "F1 = F2" ];
    text = "(1 - m1/m2)/2*(-m2/M*(l_end - l_start))"; },
  { name = "half"; start = "steady"; of = "v_start"; claimed = 1; when = [ "alpha = 1/2", "m1 > 3*m2" ]; text = "0"; },
  { name = "twice"; start = "v0"; phase = "contraction"; of = "v_change"; claimed = 2; text = "-(F1 - F2)/M*T"; },
  { name = "unclaimed"; of = "dT"; text = "T"; }
);
END

# ---- verdicts ----
run 1 claims --book mine.cfg --gait quadratic
cells out claim verdict derived_order inside source >got
cat >wanted <<'END'
my_xC refuted 4 yes book
my_xC:derived sharper 8 yes corrected
equal holds none yes book
half holds 1 yes book
twice holds 2 yes book
END
cmp -s got wanted || note "$(diff got wanted)"
[ "$(cat err)" = "3 hold, 0 are sharper than claimed, 1 refuted, 0 undecided" ] || note "$(cat err)"
cells out claim measured | grep -q '^half .*alpha=1/2' || note "half: of which crawler? $(cells out claim measured)"
finish "claims --book: verdicts"
run 0 claims --formula "(F1-F2)/M*T" --of v_end --claimed 3 --gait trapezoidal:0.2,0.3
[ "$(cells out verdict derived_order)" = "holds 3" ] || note "$(cells out verdict derived_order)"
run 1 claims --formula "(F1-F2)/M*T" --of v_end --claimed 4 --gait polynomial:0,3,-2
[ "$(cells out verdict derived_order | head -n 1)" = "refuted 3" ] || note "$(cells out verdict derived_order)"
run 0 claims --formula "v0 - (F1 - F2)/M*T" --of v_end --start v0 --phase contraction --claimed 2 --gait quadratic
[ "$(cells out verdict derived_order)" = "holds 2" ] || note "$(cells out verdict derived_order)"
run 0 claims --formula "(F1 - F2)*(2*alpha - 1)*L*m1*m2/M/(alpha^2*F1*m1 + (1 - alpha)^2*F2*m2)" --of displacement --claimed 4 --gait quadratic
[ "$(cells out verdict)" = holds ] || note "$(cells out verdict)"
run 1 claims --formula "(F1-F2)/M*T" --of v_end --start v0 --claimed 2 --gait quadratic
[ "$(cells out derived_order coefficient leading_error | head -n 1)" = "0 17/10 v0" ] || note "$(cells out derived_order coefficient leading_error) $(cat err)"
[ "$(cells out measured | sort -u)" = "v0=17/10" ] || note "v0 is not printed: $(cells out measured)"
finish "claims --formula"
# With m1 = m2 the first term of what is left out vanishes: so it does of this crawler, and of no other.
run 0 claims --formula "(F1-F2)/M*T + (m1 - m2)*T^2" --of v_end --claimed 3 --gait quadratic --m1 1 --m2 1 --F1 4 --F2 1 --L 10 --alpha 0.75
[ "$(cells out verdict derived_order)" = "holds 3" ] || note "$(cells out verdict derived_order)"
[ "$(cells out reason)" = "of other crawlers as T^2" ] || note "the coincidence is not said: $(cells out reason)"
run 1 claims --formula "(F1-F2)/M*T + (m1 - m2)*T^2" --of v_end --claimed 4 --gait quadratic --m1 1 --m2 1 --F1 4 --F2 1 --L 10 --alpha 0.75
[ "$(cells out reason | head -n 1)" = "the error goes as T^3; of other crawlers as T^2" ] || note "$(cells out reason)"
# A number that fits one crawler is a coincidence, unless that crawler is asked about.
run 1 claims --formula 147537/67265 --of displacement --claimed 2 --gait quadratic
[ "$(cells out verdict reason | head -n 1)" = \
  "refuted the error goes as T^4; of other crawlers as T^0" ] || note "$(cells out verdict reason)"
run 0 claims --formula 147537/67265 --of displacement --claimed 2 --gait quadratic --m1 1.3
[ "$(cells out verdict reason)" = "sharper the error goes as T^4; of other crawlers as T^0" ] || note "$(cells out verdict reason)"
finish "an order that only the given crawler has"

# A crawler that a formula is not for refutes nothing, and proves nothing.
cat >conditions.cfg <<'END'
formulas = ( { name = "at_rest"; start = "steady"; of = "displacement"; claimed = "equality"; text = "0"; when = [ "F1 = F2" ]; },
  { name = "no_turn"; start = "steady"; of = "v_start"; claimed = 1; turns = "not in the contraction";
    text = "m2*L_kin*((F1 - F2)*alpha - (F1 + F2)*(1 - alpha))/(F1*M*alpha^2)/T"; } );
END
run 0 claims --book conditions.cfg --gait quadratic
[ "$(cells out verdict inside)" = "holds yes
holds yes" ] || note "$(cells out verdict inside)"
grep -q '	steady state, no body turns in the contraction	yes' out || note "$(cells out conditions)"
m1=$(cells out measured | sed -n '2s/ .*//p')
[ -n "$m1" ] || note "no_turn: of which crawler?"
run 3 claims --book conditions.cfg --gait quadratic --F1 4
[ "$(cells out verdict inside)" = "refuted no
undecided no" ] || note "$(cells out verdict inside)"
[ "$(sed -n 2p err)" = "where the conditions of a formula are not met: 0 hold, 0 are sharper than claimed, 1 refuted, 1 undecided" ] || note "$(cat err)"
[ "$(cells out reason | tail -n 1)" = "the formula is for crawlers of which, as T -> 0, no body turns in the contraction; of this crawler a body turns in both phases" ] ||
  note "$(cells out reason)"
run 0 claims --book conditions.cfg --errors no_turn --m1 0.013 --gait quadratic
[ "$(rows out | wc -l)" -ge 12 ] || note "errors of no_turn: $(rows out | wc -l)"
finish "the crawlers that a formula is for"

# ---- the paper's own book ----
"$tool" claims --book "$root/asymptotics/published/paper.cfg" --quiet >out 2>err
python out "$root/data/claims.tsv" <<'END'
ledger = {}
for r in read(sys.argv[2]):
    if r["inside"] == "yes" and r["source"] != "book":
        ledger.setdefault((r["claim"], r["gait"]), set()).add((r["verdict"], r["derived_order"]))
compared = 0
for r in read(sys.argv[1]):
    key, decided = (r["claim"], r["gait"]), {(r["verdict"], r["derived_order"])}
    if key in ledger:
        compared += 1
        if decided != ledger[key]:
            bad(key, decided, "in the ledger", ledger[key])
    elif "no_turn" not in r["claim"]: # what no crawler of the paper does
        bad(key, "is not in the ledger")
if compared != 120:
    bad(compared, "compared")
END
finish "the paper's book: the verdicts of the ledger"

# ---- what is wrong with a book ----
refuse() { # PATTERN MEMBERS: of the second formula
  printf 'formulas = ( { name = "f"; of = "v_end"; claimed = 3; text = "(F1-F2)/M*T"; },\n  { %s } );\n' "$2" >bad.cfg
  run 2 claims --book bad.cfg
  grep -q -e "^scallop claims: bad.cfg:2: $1" err || note "$2: $(cat err)"
}
end='of = "v_end"; claimed = 3;'
refuse "g: character 5: 'F3' is no quantity known here: did you mean 'F1'?" "name = \"g\"; $end text = \"(F1-F3)\";"
refuse "g: character 1: this '(' is not closed" "name = \"g\"; $end text = \"(F1-F2\";"
refuse "g: part, character 4: a number, a name or '(' is missing" "name = \"g\"; $end text = \"1 + part\"; where = { part = \"F1*\"; };"
refuse "g: .*too much within one another" "name = \"g\"; $end text = \"a\"; where = { a = \"b\"; b = \"a\"; };"
refuse "g: .*too long" "name = \"g\"; $end text = \"$(awk 'BEGIN { for (i = 0; i < 200; i++) printf "T+"; print "T" }')\";"
refuse 'claimed is the power of T' 'name = "g"; of = "v_end"; claimed = 0; text = "T";'
refuse 'claimed is the power of T' 'name = "g"; of = "v_end"; claimed = 2.5; text = "T";'
refuse 'claimed is the power of T' 'name = "g"; of = "v_end"; claimed = "none"; text = "T";'
refuse 'of is a text in quotes, one of dx1' 'name = "g"; of = "speed"; claimed = 3; text = "T";'
refuse "there is a formula 'f' already" "name = \"f\"; $end text = \"T\";"
refuse "'g h' cannot be the name of a formula" "name = \"g h\"; $end text = \"T\";"
refuse "a formula has no name" "$end text = \"T\";"
refuse "a formula has no text" "name = \"g\"; $end"
refuse "a formula has no 'of'" 'name = "g"; text = "T";'
refuse 'displacement is a quantity of the steady state' 'name = "g"; of = "displacement"; claimed = 3; text = "T";'
refuse 'v_end is a quantity of one phase' "name = \"g\"; $end start = \"steady\"; text = \"T\";"
refuse 'g: the steady state has no t1' 'name = "g"; of = "v_start"; start = "steady"; claimed = 3; text = "t1";'
refuse "'m1' cannot be the name of a part: it has a meaning in formulas" "name = \"g\"; $end text = \"T\"; where = { m1 = \"3\"; };"
refuse 'g: "alpha": a condition is LEFT < RIGHT' "name = \"g\"; $end text = \"T\"; when = [ \"alpha\" ];"
refuse "there is no 'txt' in a formula: did you mean 'text'?" "name = \"g\"; $end text = \"T\"; txt = \"T\";"
refuse 'from rest a formula is for an extension' "name = \"g\"; $end phase = \"contraction\"; text = \"T\";"
refuse "'sqrt' cannot be the name of a part: it has a meaning in formulas" "name = \"g\"; $end text = \"T\"; where = { sqrt = \"3\"; };"
refuse "'a-b' cannot be the name of a part: a name begins with a letter" "name = \"g\"; $end text = \"T\"; where = { a-b = \"3\"; };"
refuse "g: unused, character 4: a number" "name = \"g\"; $end text = \"T\"; where = { unused = \"3 +\"; };"
refuse "where is a group of names and texts" "name = \"g\"; $end text = \"T\"; where = 3;"
refuse "a takes a formula in quotes" "name = \"g\"; $end text = \"a\"; where = { a = 3; };"
refuse "where has more than 16 parts" "name = \"g\"; $end text = \"T\"; where = { $(awk 'BEGIN { for (i = 0; i < 17; i++) printf "a%d = \"T\"; ", i }') };"
refuse "g: a, character 1: .*does the part use itself?" "name = \"g\"; $end text = \"a\"; where = { a = \"a\"; };"
for name in T xC v_end gait status derived_x; do
  refuse "'$name' cannot be the name of a formula: there is a quantity of this name" "name = \"$name\"; $end text = \"T\";"
done
refuse "'pi' cannot be the name of a formula: it has a meaning in formulas" "name = \"pi\"; $end text = \"T\";"
refuse "g: \"F1 > t1\": a condition is about the crawler, which has no t1" "name = \"g\"; $end text = \"T\"; when = [ \"F1 > t1\" ];"
refuse "g: \"T < 1\": a condition is about the crawler, which has no T" "name = \"g\"; $end text = \"T\"; when = [ \"T < 1\" ];"
refuse "g: \"F1 > G1\": character 6: 'G1' is no quantity" "name = \"g\"; $end text = \"T\"; when = [ \"m1 > m2\", \"F1 > G1\" ];"
refuse "g: there is no formula 'rest_dt': did you mean 'rest_dT'?" "name = \"g\"; $end text = \"T\"; corrected = \"rest_dt\";"
refuse "turns is about the steady state" "name = \"g\"; $end text = \"T\"; turns = \"not in the extension\";"
refuse "turns is a text in quotes, one of in both phases" "name = \"g\"; $end text = \"T\"; turns = \"always\";"
refuse "the steady state has both phases" 'name = "g"; of = "v_start"; start = "steady"; claimed = 3; text = "T"; phase = "contraction";'
refuse "syntax error: in this line or before it" "name = g; $end text = \"T\";"
refuse "duplicate setting name: a group has each of its members once" "name = \"g\"; name = \"h\"; $end text = \"T\";"
printf 'formulas = ( { name = "f"; of = "v_end"; claimed = 3; corrected = "later"; text =\n"T"\n"+ T +"; } );' >bad.cfg
run 2 claims --book bad.cfg
grep -q '^scallop claims: bad.cfg:1: f: character 7: ' err || note "a text of two lines: $(cat err)"
printf 'formulas = ( { name = "f"; of = "v_end"; claimed = 9; corrected = "later"; text = "T"; }, { name = "later"; of = "v_end"; text = "T"; } );' >later.cfg
run 1 claims --book later.cfg --gait quadratic
[ "$(cells out corrected)" = later ] || note "corrected: $(cells out corrected)"
finish "a formula that is none: file, line, and place in the formula"
option() { # MESSAGE ARGUMENT...
  said=$1
  shift
  run 2 claims "$@"
  [ "$(cat err)" = "scallop claims: $said" ] || note "$*: $(cat err)"
}
option "--formula: character 1: 'sqr' is no function: there are abs sqrt exp log log10 sin cos asin min max: did you mean 'sqrt'?" --formula "sqr(T)" --of v_end --claimed 3
option "--formula: character 3: 'F3' is no quantity known here: did you mean 'F1'?" --formula "T+F3" --of v_end --claimed 3
option "--formula: character 1: this '(' is not closed" --formula "(T" --of v_end --claimed 3
option "--formula: the steady state has no v0" --formula "v0" --of v_start --claimed 3
option "--formula: v_start is a quantity of the steady state: give it start = \"steady\"" --formula T --of v_start --claimed 3 --start rest
option "--formula: the steady state has both phases: leave phase out" --formula T --of v_mid --claimed 3 --phase contraction
for claimed in 0 -1 2.5 1000 99999999999 Equality; do
  option '--formula: claimed is the power of T in "+ O(T^n)", from 1 to 999, or "equality"' --formula T --of v_end --claimed $claimed
done
option "--start: 'end' is not allowed here: it takes rest, v0 or steady" --formula T --of v_end --claimed 3 --start end
option "--phase: 'both' is not allowed here: it takes extension or contraction" --formula T --of v_end --claimed 3 --phase both
run 2 claims --formula T --claimed 3 --of speed
grep -q "^scallop claims: --of: 'speed' is not allowed here: it takes dx1, dx2, .*mean_velocity or friction_work$" err || note "$(cat err)"
finish "a formula on the command line that is none"
whole() { # PATTERN TEXT: of the file
  printf '%s\n' "$2" >bad.cfg
  run 2 claims --book bad.cfg
  grep -q -e "^scallop claims: bad.cfg$1" err || note "$2: $(cat err)"
}
whole ":1: there is no 'a' in a book of formulas" 'a = 1;'
whole ':1: formulas is a list' 'formulas = 3;'
whole ':1: a formula is a group' 'formulas = ( 3 );'
whole ': there is no formula' 'formulas = ( );'
whole ': no formula of this book has a claim' 'formulas = ( { name = "a"; of = "v_end"; text = "T"; } );'
whole ':2: syntax error' 'formulas = ( { name = "f" of = '
run 4 claims --book none.cfg
run 4 claims --book figure4
[ "$(cat err)" = "scallop claims: cannot read figure4: No such file or directory" ] || note "$(cat err)"
run 4 claims --book .
printf 'a\0b' >bad.cfg
run 2 claims --book bad.cfg
grep -q 'this is not a text file' err || note "$(cat err)"
run 2 claims --formula T
run 2 claims --formula T --of v_end
run 2 claims --of v_end
finish "files that are no books"
# A book that can be read once only
run 1 claims --book mine.cfg --quiet
sed 's/book: .*/book: -/' out >wanted
"$tool" claims --book - --quiet <mine.cfg >got 2>err
cmp -s wanted got || note "standard input: $(head -n 2 err)"
# shellcheck disable=SC2002 # a pipe is wanted
cat mine.cfg | "$tool" series --book /dev/stdin >got 2>err
run 0 series --book mine.cfg
[ -s got ] && cmp -s out got || note "a pipe: $(head -n 2 err)"
finish "a book on standard input and on a pipe"
# What a series cannot do is said, and the verdict is open
printf 'formulas = ( { name = "g"; of = "v_end"; claimed = 3; text = "T + log(T)"; }, { name = "h"; of = "v_end"; claimed = 3; text = "T/(m1 - m1)"; },
  { name = "k"; of = "v_end"; claimed = 3; text = "T"; when = [ "alpha > 2" ]; } );\n' >open.cfg
run 3 claims --book open.cfg --gait quadratic
[ "$(cells out verdict | sort -u)" = undecided ] || note "$(cells out claim verdict)"
grep -q 'character 5: log' out || note "$(cells out reason)"
grep -q ':[0-9]*: character 2: / divides by what may be 0' out || note "$(cells out reason)"
grep -q 'no crawler was found for which the conditions hold' out || note "$(cells out reason)"
finish "what a series cannot do"

# ---- the leading error as a formula: added to the text it takes the error one order further ----
further() { # ORDER FORMULA OF ARGUMENT...
  order=$1 text=$2 of=$3
  shift 3
  run 1 claims --formula "$text" --of "$of" --claimed 20 "$@"
  more=$(cells out leading_error)
  run 1 claims --formula "$text + $more" --of "$of" --claimed 20 "$@"
  [ "$(cells out derived_order)" = "$order" ] || note "$text + $more: order $(cells out derived_order)"
}
further 8 "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))" displacement --gait quadratic
further 3 "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*T*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))" v_start --gait quadratic
further 2 "L" displacement --gait trapezoidal:0.2,0.3
further 5 "(F1 - F2)/M*T" v_end --gait sinusoidal
further 1 "dT*(F1 - F2)/m2" v_end --gait quadratic --start v0 --phase contraction
further 2 "-(F1 - F2)*T/m1" v_change --gait sinusoidal --start v0 --phase contraction
run 1 claims --formula "sqrt(m1^2)" --of v_end --claimed 3 --gait quadratic
[ "$(cells out leading_error | head -n 1)" = - ] || note "sqrt: $(cells out leading_error)"
run 1 claims --formula "L" --of v_start --claimed 3 --gait sinusoidal
[ "$(cells out leading_error)" = - ] || note "no closed form: $(cells out leading_error)"
run 1 claims --formula "L" --of v_start --claimed 3 --gait quadratic --errors all
grep -q leading_error out && note "--errors has no leading error"
finish "claims: the leading error as a formula"

# ---- what holds in place of a refuted formula: to the claimed order, as a formula that can be pasted ----
instead() { # TEXT OF CLAIMED ARGUMENT...
  text=$1 of=$2 claimed=$3
  shift 3
  run 1 claims --formula "$text" --of "$of" --claimed "$claimed" "$@"
  [ "$(cells out corrected | sed -n 1p)" = formula:derived ] || note "$text: no correction is named"
  right=$(cells out formula | sed -n 2p)
  run 0 claims --formula "$right" --of "$of" --claimed "$claimed" "$@"
  [ "$(cells out evidence)" = "proven for all parameters" ] || note "$text: instead $right: $(cells out verdict evidence)"
}
instead "F1*T" v_start 2 --gait quadratic
instead "T*F1/m1 + t1" v_end 4 --gait sinusoidal --start v0
instead "L" displacement 2 --gait trapezoidal:0.2,0.3
run 1 claims --formula "F1*T" --of v_start --claimed 2 --gait quadratic --T 0.01
python out <<'END'
rows = read(sys.argv[1])
wrong, right = (number(r, "error_at_T") for r in rows)
if not (near(wrong, 3.7 * 0.01 / 219.336 - 1, 1e-3) and abs(right) < 1e-9):
    bad("error_at_T", wrong, right)
END
run 1 claims --formula "L" --of v_start --claimed 3 --gait sinusoidal
[ "$(rows out | wc -l)" = 1 ] || note "the steady state of the sinusoidal gait has no closed form, but: $(cells out formula)"
run 2 claims --T 2
run 2 claims --T 2 --formula L --of v_start --claimed 3 --errors all
finish "claims: the formula that holds, and both errors at T"
dimension() { # TEXT OF REASON
  run 1 claims --formula "$1" --of "$2" --claimed 20 --gait quadratic
  case $(cells out reason | head -n 1) in "by dimension: $3"*) ;; *) note "$1: $(cells out reason)" ;; esac
}
dimension "F1*T" v_start "mass length/time and not length/time;"
dimension "L + F1*T^2" dxC "a sum of unlike quantities and not length;"
dimension "sqrt(L)/T" v_end "length^0.5/time and not length/time;"
dimension "F1/m1" friction_work "length/time^2 and not mass length^2/time^2;"
run 1 claims --formula "2*F1*T/m1" --of v_end --claimed 2 --gait quadratic
[ "$(cells out reason | head -n 1)" = "the error goes as T^1" ] || note "a velocity is refuted by its dimension: $(cells out reason)"
finish "claims: refuted by dimension"
run 1 claims --formula "F1*T" --of v_start --claimed 2 --format table
[ "$(sed -n '/^claim /,$p' out | grep -v '^formula ' | awk 'length > 80' | wc -l)" = 0 ] || note "not within 80 columns: $(cat out)"
grep -q '^leading_error  .*[.][.][.] ([0-9]* characters: --format tsv)$' out || note "the leading error is not shortened: $(grep leading out)"
[ "$(grep -c '^verdict ' out)" = 3 ] || note "not upright: $(cat out)"
finish "claims --formula for people: each row upright"

# ---- by name in the other commands ----
run 0 series --T 0.1 --book mine.cfg
[ "$(cells out formula published | sed -n 1p)" = "my_xC 3.2432432432432434" ] || note "series: $(cells out formula published | sed -n 1p)"
cells out formula published | sed -n 's/^text_steady_xC //p' >paper
grep -qx "$(cells out published | sed -n 1p)" paper || note "series: my_xC is (28), $(cat paper)"
run 0 breakdown --book mine.cfg --only reach --quantity displacement --tol 0.001
awk -F '\t' '$3 == "my_xC" || $3 == "text_steady_xC" { print $6 }' out >reach
{ [ "$(wc -l <reach)" = 2 ] && [ "$(sort -u reach | wc -l)" = 1 ]; } || note "breakdown: $(cat reach)"
run 0 workprec --quick --limit 0.001 --book mine.cfg --gait quadratic
grep -q '^book	.*my_xC' out || note "workprec: no my_xC"
printf 'book = "mine.cfg"; vary = ( { T = { from = 0.05; to = 0.4; count = 4; spacing = "log"; }; } );
want = ( { what = "orders"; of = [ "my_xC", "text_steady_xC" ]; file = "orders.tsv"; } );\n' >scene.cfg
mkdir there && cp mine.cfg scene.cfg there
run 0 run there/scene.cfg
cells orders.tsv order >got
{ [ "$(wc -l <got)" = 2 ] && [ "$(sort -u got | wc -l)" = 1 ]; } || note "scene: $(cat got)"
sed -n 1p got | awk '{ exit !($1 > 3.9 && $1 < 4.1) }' || note "the order of (28): $(cat got)"
sed 's/orders.tsv/others.tsv/' there/scene.cfg >there/other.cfg
run 0 run there/scene.cfg ./there/../there/other.cfg --check-only
run 2 run there/scene.cfg scene.cfg --check-only
grep -q "^scallop run: mine.cfg:2: there is a formula 'my_xC' already, in there/mine.cfg" err || note "two books: $(cat err)"
printf 'book = "none.cfg"; want = ( { what = "steady"; } );\n' >scene.cfg
run 2 run scene.cfg
grep -q 'cannot read none.cfg' err || note "$(cat err)"
printf 'vary = ( { T = [ 0.1, 0.2 ]; label = { my_xC = [ "a", "b" ]; }; } ); book = "mine.cfg"; want = ( { what = "steady"; } );\n' >scene.cfg
run 2 run scene.cfg
grep -q 'a label cannot be called my_xC, which is a quantity' err || note "$(cat err)"
finish "formulas of a book by name: series, breakdown, workprec, a scene"

# ---- a map has the formulas of the book, each in columns of its own ----
printf 'formulas = ( { name = "limit_again"; of = "displacement"; start = "steady";
  text = "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))"; },
  { name = "twice"; of = "displacement"; start = "steady"; text = "2*limit"; where = {
    limit = "m1*m2*L*(2*alpha - 1)*(F1 - F2)/(M*(m1*F1*alpha^2 + m2*F2*(1 - alpha)^2))"; }; },
  { name = "velocity"; of = "v_end"; text = "T"; } );\n' >map.cfg
map='--map F1/F2 alpha --x 2:4:2 --y 0.6:0.8:2 --tol 0.01'
# shellcheck disable=SC2086
run 0 breakdown $map --book map.cfg
python out <<'END'
rows = read(sys.argv[1])
for r in rows:
    if (r["error_limit_again"], r["T_1e-2_limit_again"]) != (r["error_limit"], r["T_1e-2_limit"]):
        bad("(28) is the limit of the quadratic gait", r)
    if not near(number(r, "error_twice"), 1 + 2 * number(r, "error_limit"), 1e-14) or r["T_1e-2_twice"] != "0":
        bad("twice the limit", r)
    if "error_velocity" in r or "error_published" not in r:
        bad(list(r))
END
# shellcheck disable=SC2086
run 0 breakdown $map --book map.cfg --source book
[ "$(grep -v '^#' out | head -n 1 | tr '\t' '\n' | grep -c '^error_\|^T_')" = 4 ] || note "--source book: $(grep -v '^#' out | head -n 1)"
finish "formulas of a book in a map"

# ---- a book without effect ----
idle() { # MESSAGE ARGUMENT...
  said=$1
  shift
  run 2 "$@"
  [ "$(cat err)" = "scallop $1: $said" ] || note "$*: $(cat err)"
}
printf 'formulas = ( { name = "velocity"; of = "v_end"; text = "T"; } );\n' >phase.cfg
{ echo 'formulas = ('; awk 'BEGIN { for (i = 0; i < 25; i++) printf "%s{ name = \"a%d\"; of = \"v_start\"; start = \"steady\"; text = \"L\"; }", i ? ", " : "", i }'; echo ');'; } >many.cfg
none="--book is for the published formulas: --source derived, limit and --bound have none"
idle "$none" series --source derived --book map.cfg
idle "$none" series --source limit --book map.cfg
idle "$none" series --bound --book map.cfg
idle "--book needs its own series: leave --source out, or --source book" breakdown --book map.cfg --source limit
idle "--source book needs --book FILE" breakdown --source book
for only in event radius best; do
  idle "--book needs the rows of --only reach" breakdown --book map.cfg --only $only
done
idle "--book: no formula of map.cfg is about the v_mid of this motion" breakdown --book map.cfg --quantity v_mid
idle "--book: no formula of phase.cfg is about this motion" breakdown --book phase.cfg --all
idle "--book: no formula of phase.cfg is about this motion" breakdown --book phase.cfg --phase extension --v0 1
run 0 breakdown --book phase.cfg --phase extension --source book --tol 0.1
# shellcheck disable=SC2086
idle "--book: no formula of phase.cfg is about the displacement of the steady state" breakdown $map --book phase.cfg
for option in '--book map.cfg' '--source limit' '--order 8' '--quantity v_mid' '--tol 0.1'; do
  # shellcheck disable=SC2086
  idle "${option%% *} has nothing to do with --boundaries" breakdown --map F1/F2 alpha --boundaries $option
done
for command in breakdown summary 'workprec --quick'; do
  # shellcheck disable=SC2086
  idle "--book: no formula of phase.cfg is about the steady v_start or displacement" $command --book phase.cfg
  # shellcheck disable=SC2086
  idle "--book: more than 24 formulas of many.cfg are about the steady v_start or displacement" $command --book many.cfg
done
finish "a book without effect is refused"
exit $failed
