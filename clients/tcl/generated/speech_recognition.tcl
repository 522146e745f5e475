# Interface speech_recognition, code 50. Reports recognised speech.
#
# Generated from interfaces/050_speech_recognition.toml by codegen; do not edit.

::playhouse::wire::interface speech_recognition 50 {
    # Recognised speech. (player_speech_recognition_data_t)
    #   text: NUL-terminated.
    struct Data {
        text char[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu text.count
        incr at 4
        set text [opaque $body [length $body text ${text.count} 1]]
        return [dict create text $text]
    } {
        append out [count text [string length [dict get $value text]] 33554392]
        append out [count text [string length [dict get $value text]] 33554392]
        append out [pad text [dict get $value text]]
        return $out
    }

    # Recognised words.
    message speech_recognition.data.string DATA 1 speech_recognition.Data
}
