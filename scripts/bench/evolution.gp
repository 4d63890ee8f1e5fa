# Plots the Hausdorff distance from the exact surface against CPU seconds, for each case.
set terminal svg size 1200,700 background 'white'
set output output
set datafile separator '\t'
set logscale xy
set format y '10^{%T}'
set xlabel 'CPU seconds, one thread'
set ylabel 'Hausdorff distance'
set grid
set key bottom left
rows(case, program) = sprintf("< awk -F '\\t' '$1 == \"%s\" && $2 == \"%s\"' %s", case, program, table)
programs(case) = system(sprintf("awk -F '\t' '$1 == \"%s\" { print $2 }' %s | uniq", case, table))
set multiplot layout 2,3
do for [case in cases] {
  set title case
  plot for [program in programs(case)] rows(case, program) \
    using ($6 > 0.01 ? $6 : 0.01):10 with linespoints pointtype 7 title program
}
unset multiplot
