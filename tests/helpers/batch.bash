# Runs batches of scripts/experiments; the table is the file `table` in the current folder.

# batch TARGET...: runs the shipped Makefile, with results in the current folder.
batch() { make -s -C "$tm_root/scripts/experiments" BUILD="$tm_build" OUT="$PWD" TABLE="$PWD/table" "$@"; }

# columns FOLDER: prints the table of results without seconds and memory.
columns() { cut -d, -f1-4,7- "$1/table.csv" | tr -d '"'; }
