# Who is cheapest for a wanted error: from a table of `scallop workprec`.
#   LC_ALL=C awk -f scripts/plots/cheapest.awk data/workprec.tsv
BEGIN {
  FS = OFS = "\t"
  quantities = split("v_start displacement", quantity, " ")
  wanteds = split("1e-2 1e-4 1e-6 1e-8 1e-10 1e-12 1e-15 1e-30 1e-100", wanted, " ")
  needed = split("method kind setting gait T quantity error time_median status", need, " ")
}
/^# parameters: / { print }
/^#/ || $0 == "" { next }
!columns {
  columns = NF
  for (i = 1; i <= NF; i++)
    at[$i] = i
  for (i = 1; i <= needed; i++)
    if (!(need[i] in at)) {
      print "cheapest.awk: no column '" need[i] "': scallop workprec writes such a table, as TSV" >"/dev/stderr"
      exit failed = 2
    }
  print "gait", "T", "quantity", "target_error", "method", "setting", "error", "next_method", "next_setting", "next_ratio", \
    "exact_method", "exact_setting", "exact_ratio", "integrator_method", "integrator_setting", "integrator_over_exact", "simulation_method", \
    "simulation_setting", "simulation_over_exact"
  next
}
NF != columns {
  print "cheapest.awk: line " FNR ": not as many columns as in the header" >"/dev/stderr"
  exit failed = 2
}
{
  point = $at["gait"] OFS $at["T"]
  if (point != last)
    summarise()
  last = point
  if ($at["status"] != "ok")
    next
  n++
  method[n] = $at["method"]
  setting[n] = $at["setting"]
  of[n] = $at["quantity"]
  error[n] = $at["error"]
  time[n] = $at["time_median"]
  is[n] = $at["kind"]
}
END {
  if (!failed)
    summarise()
  exit failed
}

# The way of these kinds ("": of any), and of another method than this, that reaches the error in the least time; 0: none does.
function cheapest(what, least_error, kinds, other_than,  i, best) {
  for (i = 1; i <= n; i++)
    if (of[i] == what && error[i] + 0 <= least_error + 0 && is[i] ~ kinds && method[i] != other_than \
        && (!best || time[i] + 0 < time[best] + 0))
      best = i
  return best + 0
}

function ratio(way, to) {
  return (way ? method[way] : "-") OFS (way ? setting[way] : "-") OFS (way && to ? sprintf("%.3g", time[way] / time[to]) : "nan")
}

function summarise(  q, w, what, limit, best, exact) {
  for (q = 1; q <= quantities; q++)
    for (w = 1; w <= wanteds; w++) {
      what = quantity[q]
      limit = wanted[w]
      best = cheapest(what, limit, "")
      exact = cheapest(what, limit, "exact")
      if (best)
        print last, what, limit, method[best], setting[best], error[best], ratio(cheapest(what, limit, "", method[best]), best), \
          ratio(exact, best), ratio(cheapest(what, limit, "root|simulation"), exact), ratio(cheapest(what, limit, "simulation"), exact)
    }
  n = 0
}
