# Interface speech, code 12. Speaks text.
#
# Generated from interfaces/012_speech.toml by codegen; do not edit.

::playhouse::wire::interface speech 12 {
    # A text to speak. (player_speech_cmd_t)
    #   string: NUL-terminated.
    struct Cmd {
        string char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu string.count
        incr at 4
        set string [opaque $body [length $body string ${string.count} 1]]
        return [dict create string $string]
    } {
        append out [count string [string length [dict get $value string]] 33554392]
        append out [count string [string length [dict get $value string]] 33554392]
        append out [pad string [dict get $value string]]
        return $out
    }

    # Speaks a text; texts are spoken one after the other.
    message speech.cmd.say CMD 1 speech.Cmd
}
