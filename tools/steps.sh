# For scripts with set -e that source it: step NAME COMMAND... runs a step of a long job; report_steps prints the seconds of
# each, also of one that failed, of which step_name is the name.

steps=
step_name=

step() {
  step_name=$1
  shift
  echo "== $step_name"
  step_start=$(date +%s)
  "$@"  # not in a condition, in which set -e would not hold
  note_step
}

note_step() {
  steps="$steps$(printf '%6d s  %s' $(($(date +%s) - step_start)) "$step_name")
"
  step_name=
}

report_steps() {
  [ -z "$step_name" ] || note_step
  echo "== time of each step, on $(nproc) cores"
  printf '%s' "$steps"
}
