# Runs an ssh server on the loopback interface for a test, with keys and settings in a folder.
# stop_sshd stops exactly this server.

# start_sshd FOLDER: starts the ssh server with its files in FOLDER, and sets $ssh_command to the
# client with its settings. Skips the test, with the reason, if the server cannot be started.
start_sshd() {
  local command port tries
  for command in ssh ssh-keygen sshd; do
    command -v "$command" >/dev/null || PATH=$PATH:/usr/sbin
    needs_command "$command"
  done
  sshd_folder=$1
  port=$((20000 + $$ % 20000 + 2))
  mkdir -p "$sshd_folder"
  chmod 0700 "$sshd_folder"
  ssh-keygen -q -t ed25519 -N '' -f "$sshd_folder/host_key"
  ssh-keygen -q -t ed25519 -N '' -f "$sshd_folder/user_key"
  # An init system would create this folder, but containers may have none.
  [ "$(id -u)" -ne 0 ] || mkdir -p /run/sshd
  cat >"$sshd_folder/sshd_config" <<CONF
ListenAddress 127.0.0.1
Port $port
HostKey $sshd_folder/host_key
AuthorizedKeysFile $sshd_folder/user_key.pub
PasswordAuthentication no
PermitRootLogin prohibit-password
StrictModes no
UsePAM no
PidFile none
MaxStartups 100
CONF
  cat >"$sshd_folder/config" <<CONF
Host node
  HostName 127.0.0.1
  Port $port
  IdentityFile $sshd_folder/user_key
  IdentitiesOnly yes
  BatchMode yes
  StrictHostKeyChecking no
  UserKnownHostsFile $sshd_folder/known_hosts
  LogLevel ERROR
CONF
  ssh_command="ssh -F $sshd_folder/config"
  "$(command -v sshd)" -D -e -f "$sshd_folder/sshd_config" 2>"$sshd_folder/log" 3>&- &
  sshd_id=$!
  for tries in $(seq 100); do
    if $ssh_command node true 2>>"$sshd_folder/log" </dev/null; then return; fi
    sleep 0.1
  done
  tail -n 3 "$sshd_folder/log" || true
  stop_sshd
  skip "sshd does not start here: no login after $tries tries"
}

stop_sshd() {
  kill "$sshd_id" 2>/dev/null || true
  wait "$sshd_id" 2>/dev/null || true
  sshd_id=
}
