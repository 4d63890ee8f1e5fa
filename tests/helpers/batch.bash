# Batches of scripts/experiments with the table of the current folder.

# batch TARGET...: with the shipped Makefile, results in the current folder.
batch() { make -s -C "$tm_root/scripts/experiments" BUILD="$tm_build" OUT="$PWD" TABLE="$PWD/table" "$@"; }

# columns FOLDER: the table without seconds and memory.
columns() { cut -d, -f1-4,7- "$1/table.csv" | tr -d '"'; }
