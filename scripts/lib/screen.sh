# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# A virtual screen for programs that need one. Needs common.sh.

# start_screen: DISPLAY is a screen of this script's own afterwards, which ends with it. The server chooses a number that
# is free, so that scripts which start at once do not meet; what the user's desktop asks of Qt does not hold there.
start_screen() {
  local ready
  if [[ -n ${screen_pid:-} ]]; then return; fi
  exec {ready}< <(exec Xvfb -displayfd 1 -screen 0 1500x1300x24 -nolisten tcp -noreset 2>/dev/null)
  screen_pid=$!
  read -r -t 20 -u "$ready" DISPLAY || die "Xvfb, the virtual screen, does not start."
  export DISPLAY=:$DISPLAY QT_QPA_PLATFORM=xcb
  unset WAYLAND_DISPLAY QT_QPA_PLATFORMTHEME QT_STYLE_OVERRIDE QT_PLUGIN_PATH
}
