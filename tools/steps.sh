# For scripts that source it: step NAME COMMAND... runs a step of a long job; report_steps prints the seconds of each.

steps=

step() {
  step_name=$1
  shift
  echo "== $step_name"
  step_start=$(date +%s)
  step_status=0
  "$@" || step_status=$?
  steps="$steps$(printf '%6d s  %s' $(($(date +%s) - step_start)) "$step_name")
"
  [ "$step_status" -eq 0 ] || exit "$step_status"
}

report_steps() {
  echo "== time of each step"
  printf '%s' "$steps"
}
