# Shared by bare.sh, flint3.sh and release.sh: an apt apart from the machine's, in FOLDER, that knows what "deb LINE" of a sources list
# has, and no installed package: apart FOLDER LINE. Then apt-get and apt-cache are those.
apart() {
  mkdir -p "$1/lists/partial" "$1/archives/partial"
  echo "deb $2" >"$1/sources.list"
  cat >"$1/apt.conf" <<CONF
Dir { State "$1"; State::status "/dev/null"; Cache "$1"; };
APT::Sandbox::User "root";
Dir::Etc { SourceList "$1/sources.list"; SourceParts "/dev/null"; Preferences "/dev/null"; PreferencesParts "/dev/null"; };
CONF
  export APT_CONFIG="$1/apt.conf"
  apt-get update -qq
}
# The address from which the machine has its own packages, with what they are signed by: a line for apart, without suite
mirror() {
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  address=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Identifier: Packages' | sed -n "s/ $codename\$//p" | head -n 1)
  keys=$(find /usr/share/keyrings -name "$(. /etc/os-release && echo "$ID")-archive-keyring.gpg")
  [ -n "$address" ] && echo "[signed-by=$keys] $address"
}
