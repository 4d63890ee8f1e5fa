# Plots distances and topology against the iterations of log.csv, so that merges are visible.
set terminal pngcairo size 900,640
set output 'curves.png'
set datafile separator ','
set key autotitle columnhead
set multiplot layout 2,1 title name
set logscale y
set ylabel 'distance'
plot 'log.csv' using 1:8 with lines title 'rms to target', \
     '' using 1:9 with lines title 'max to target', \
     '' using 1:10 with lines title 'rms from target', \
     '' using 1:12 with lines dashtype 2 title 'mean edge'
unset logscale y
set ylabel 'number'
set xlabel 'iteration'
set yrange [0:*]
plot 'log.csv' using 1:4 with steps title 'components', \
     '' using 1:5 with steps title 'genus', \
     '' using 1:($3 > 0 ? log10($3) : 0) with impulses title 'log10 of intersecting pairs'
unset multiplot
