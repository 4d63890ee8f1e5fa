# Makes locales for tests from their sources, since the system may have none.

# make_locales FOLDER NAME...: makes a UTF-8 locale per name; de_DE gives de_DE.UTF-8. Set
# LOCPATH=FOLDER to use them.
make_locales() {
  local folder=$1 name
  shift
  for name in "$@"; do
    localedef -f UTF-8 -i "$name" "$folder/$name.UTF-8"
    [ "$(LOCPATH=$folder LC_ALL=$name.UTF-8 bash -c 'printf %.1f 0,5')" = 0,5 ] ||
      fail "localedef made no $name"
  done
}
