# Devices for messages and speech.

# Byte messages: those between robots for a simulated radio, driver-specific for other drivers.
oo::class create ::playhouse::Opaque {
    superclass ::playhouse::Keeping

    # Sends bytes to the driver; a radio broadcasts them to all radios in range.
    method send {message} {
        my command opaque.cmd.data [dict create data $message]
    }

    # For a radio: sends bytes to the radio with this network address, empty to broadcast. Returns when the message is
    # queued. An error of kind REFUSED for an unknown address, a message that is too long, or a full queue.
    method sendTo {address message} {
        my request opaque.req.data [dict create data [cString $address]$message]
        return
    }

    # The messages of reads since the last call, in order.
    method takeMessages {} {
        return [my TakeKept]
    }

    method Meaning {value} {return [dict get $value data]}
}

# Speech output of a robot.
oo::class create ::playhouse::Speech {
    superclass ::playhouse::Device

    # Sets the text that the robot says, replacing the previous one; empty: none.
    method say {text} {
        my command speech.cmd.say [dict create string [cString $text]]
    }
}

# Speech recognition: texts of other models heard by a robot.
oo::class create ::playhouse::SpeechRecognition {
    superclass ::playhouse::Keeping

    # The texts of reads since the last call, in order.
    method takeTexts {} {
        return [my TakeKept]
    }

    method Meaning {value} {return [text [dict get $value text]]}
}
