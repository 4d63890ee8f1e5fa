# Draws photographs, and below them the surface from the same cameras, for every other pair of files in
# pairs.txt.
photographs = system("awk 'NR % 2 == 1 { printf \"%s \", $1 }' pairs.txt")
renders = system("awk 'NR % 2 == 1 { printf \"%s \", $2 }' pairs.txt")
columns = words(photographs) / 2
set terminal pngcairo size 480 * columns, 1440
set output 'sheet.png'
unset border
unset tics
unset key
unset colorbox
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set multiplot layout 4, columns
do for [row = 0:1] {
  do for [i = 1:columns] { plot word(photographs, row * columns + i) binary filetype=png with rgbimage }
  do for [i = 1:columns] { plot word(renders, row * columns + i) binary filetype=png with rgbimage }
}
unset multiplot
