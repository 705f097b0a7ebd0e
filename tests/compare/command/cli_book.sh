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
equal holds none yes book
half holds 1 yes book
twice holds 2 yes book
END
cmp -s got wanted || note "$(diff got wanted)"
grep -q '1 hold\|3 hold, 0 are sharper than claimed, 1 refuted, 0 undecided' err || note "$(cat err)"
cells out claim measured | grep -q '^half .*alpha=1/2' || note "half: of which crawler? $(cells out claim measured)"
finish "claims --book: verdicts"
run 0 claims --formula "(F1-F2)/M*T" --of v_end --claimed 3 --gait trapezoidal:0.2,0.3
[ "$(cells out verdict derived_order)" = "holds 3" ] || note "$(cells out verdict derived_order)"
run 1 claims --formula "(F1-F2)/M*T" --of v_end --claimed 4 --gait polynomial:0,3,-2
[ "$(cells out verdict derived_order)" = "refuted 3" ] || note "$(cells out verdict derived_order)"
run 0 claims --formula "v0 - (F1 - F2)/M*T" --of v_end --start v0 --phase contraction --claimed 2 --gait quadratic
[ "$(cells out verdict derived_order)" = "holds 2" ] || note "$(cells out verdict derived_order)"
run 0 claims --formula "(F1 - F2)*(2*alpha - 1)*L*m1*m2/M/(alpha^2*F1*m1 + (1 - alpha)^2*F2*m2)" --of displacement --claimed 4 --gait quadratic
[ "$(cells out verdict)" = holds ] || note "$(cells out verdict)"
finish "claims --formula"
# With m1 = m2 the first term of what is left out vanishes: so it does of this crawler, and of no other.
run 0 claims --formula "(F1-F2)/M*T + (m1 - m2)*T^2" --of v_end --claimed 3 --gait quadratic --m1 1 --m2 1 --F1 4 --F2 1 --L 10 --alpha 0.75
[ "$(cells out verdict derived_order)" = "holds 3" ] || note "$(cells out verdict derived_order)"
grep -q 'of other crawlers as T^2' out || note "the coincidence is not said: $(cells out reason)"
finish "an order that only the given crawler has"

# ---- the paper's own book ----
"$tool" claims --book "$root/asymptotics/published/paper.cfg" --quiet >out 2>err
python out "$root/data/claims.tsv" <<'END'
ledger = {}
for r in read(sys.argv[2]):
    if r["inside"] == "yes" and r["source"] == "paper":
        ledger.setdefault((r["claim"], r["gait"]), set()).add((r["verdict"], r["derived_order"]))
compared = 0
for r in read(sys.argv[1]):
    key = r["claim"], r["gait"]
    if key in ledger and r["verdict"] != "undecided":
        compared += 1
        if (r["verdict"], r["derived_order"]) not in ledger[key]:
            bad(key, r["verdict"], r["derived_order"], "in the ledger", ledger[key])
if compared < 80:
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
refuse "'m1' cannot be the name of a part: it has a meaning already" "name = \"g\"; $end text = \"T\"; where = { m1 = \"3\"; };"
refuse 'g: "alpha": a condition is LEFT < RIGHT' "name = \"g\"; $end text = \"T\"; when = [ \"alpha\" ];"
refuse "there is no 'txt' in a formula: did you mean 'text'?" "name = \"g\"; $end text = \"T\"; txt = \"T\";"
refuse 'from rest a formula is for an extension' "name = \"g\"; $end phase = \"contraction\"; text = \"T\";"
finish "a formula that is none: file, line, and place in the formula"
whole() { # PATTERN TEXT: of the file
  printf '%s\n' "$2" >bad.cfg
  run 2 claims --book bad.cfg
  grep -q -e "^scallop claims: bad.cfg$1" err || note "$2: $(cat err)"
}
whole ":1: there is no 'a' in a book of formulas" 'a = 1;'
whole ':1: formulas is a list' 'formulas = 3;'
whole ':1: a formula is a group' 'formulas = ( 3 );'
whole ': there is no formula' 'formulas = ( );'
whole ':2: syntax error' 'formulas = ( { name = "f" of = '
run 4 claims --book none.cfg
run 4 claims --book .
run 2 claims --book mine.cfg --check
run 2 claims --formula T
run 2 claims --formula T --of v_end
run 2 claims --of v_end
finish "files that are no books"
# What a series cannot do is said, and the verdict is open
printf 'formulas = ( { name = "g"; of = "v_end"; claimed = 3; text = "T + log(T)"; }, { name = "h"; of = "v_end"; claimed = 3; text = "T/(m1 - m1)"; },
  { name = "k"; of = "v_end"; claimed = 3; text = "T"; when = [ "alpha > 2" ]; } );\n' >open.cfg
run 3 claims --book open.cfg --gait quadratic
[ "$(cells out verdict | sort -u)" = undecided ] || note "$(cells out claim verdict)"
grep -q 'character 5: log' out || note "$(cells out reason)"
grep -q 'character 2: / divides by what may be 0' out || note "$(cells out reason)"
grep -q 'no crawler was found for which the conditions hold' out || note "$(cells out reason)"
finish "what a series cannot do"

# ---- by name in the other commands ----
run 0 series --T 0.1 --book mine.cfg
[ "$(cells out formula published | sed -n 1p)" = "my_xC 3.2432432432432434" ] || note "series: $(cells out formula published | sed -n 1p)"
run 0 breakdown --book mine.cfg --only reach --quantity displacement --tol 0.001
[ "$(awk -F '\t' '$3 == "my_xC" || $3 == "text_steady_xC" { print $6 }' out | sort -u | wc -l)" = 1 ] || note "breakdown: $(cat out)"
run 0 workprec --quick --limit 0.001 --book mine.cfg --gait quadratic
grep -q '^book	my_xC' out || note "workprec: no my_xC"
printf 'book = "mine.cfg"; vary = ( { T = { from = 0.05; to = 0.4; count = 4; spacing = "log"; }; } );
want = ( { what = "orders"; of = [ "my_xC", "corrected_steady_xC_no_turn" ]; file = "orders.tsv"; } );\n' >scene.cfg
mkdir there && cp mine.cfg scene.cfg there
run 0 run there/scene.cfg
cells orders.tsv series order | sed 's/ \([0-9-]*\)\..*/ \1/' >got
grep -q '^my_xC [34]$' got || note "scene: $(cat got)"
printf 'book = "none.cfg"; want = ( { what = "steady"; } );\n' >scene.cfg
run 2 run scene.cfg
grep -q 'cannot read none.cfg' err || note "$(cat err)"
finish "formulas of a book by name: series, breakdown, workprec, a scene"
exit $failed
