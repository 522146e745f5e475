# Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels.
#
# Generated from interfaces/009_audio.toml by codegen; do not edit.

::playhouse::wire::interface audio 9 {
    # Bits of State.state.
    variable STATE_STOPPED 0
    variable STATE_PLAYING 1
    variable STATE_RECORDING 2

    # Mask of the bits of Wav.format that describe raw sound.
    variable DESCRIPTION_BITS 255

    # Bits per value of raw sound: mask and values.
    variable BITS 3
    variable 8BIT 0
    variable 16BIT 1
    variable 24BIT 2

    # Channels of raw sound.
    variable MONO 0
    variable STEREO 4

    # Sampling rate of raw sound: mask and values.
    variable FREQ 24
    variable FREQ_44k 0
    variable FREQ_11k 8
    variable FREQ_22k 16
    variable FREQ_48k 24

    # Kind of sound data: mask and values.
    variable FORMAT_BITS 65280
    variable FORMAT_NULL 0
    variable FORMAT_RAW 256
    variable FORMAT_MP3 512
    variable FORMAT_OGG 768
    variable FORMAT_FLAC 1024
    variable FORMAT_AAC 1280

    # Bits of MixerChannelDetail.caps.
    variable MIXER_CHANNEL_TYPE_INPUT 1
    variable MIXER_CHANNEL_TYPE_OUTPUT 2
    variable MIXER_CHANNEL_TYPE_SPECIAL 4

    # A sound. (player_audio_wav_t)
    #   data: The sound, in the format of `format`.
    #   format: Kind, rate, channels and bits in one number.
    struct Wav {
        data uint8[]
        format uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu data.count
        incr at 4
        set data [opaque $body [length $body data ${data.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu format
        incr at 4
        return [dict create data $data format $format]
    } {
        append out [count data [string length [dict get $value data]] 33554392]
        append out [count data [string length [dict get $value data]] 33554392]
        append out [pad data [dict get $value data]]
        append out [put uint32 [dict get $value format]]
        return $out
    }

    # One tone. (player_audio_seq_item_t)
    #   freq: in Hz.
    #   duration: in s.
    #   amplitude: 0: silent, to 1: full volume.
    #   link: On: joined to the next tone without a gap.
    struct SeqItem {
        freq float32
        duration float32
        amplitude float32
        link common.Bool
    } {
        if {[string length $body] - $at < 16} {cut $body $at {4 4 4 4}}
        binary scan $body @${at}RRRIu freq duration amplitude link.state
        incr at 16
        set link.state [low 0xff ${link.state}]
        return [dict create freq $freq duration $duration amplitude $amplitude \
            link [dict create state ${link.state}]]
    } {
        append out [put float32 [dict get $value freq]]
        append out [put float32 [dict get $value duration]]
        append out [put float32 [dict get $value amplitude]]
        append out [common::Bool.write [dict get $value link]]
        return $out
    }

    # A sequence of tones. (player_audio_seq_t)
    struct Seq {
        tones audio.SeqItem[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu tones.count
        incr at 4
        set tones {}
        for {set tones.left [length $body tones ${tones.count} 16]} {${tones.left} > 0} {incr tones.left -1} {
            lappend tones [SeqItem.read $body]
        }
        return [dict create tones $tones]
    } {
        append out [count tones [llength [dict get $value tones]] 2097149]
        append out [count tones [llength [dict get $value tones]] 2097149]
        foreach item [dict get $value tones] {append out [SeqItem.write $item]}
        return $out
    }

    # Level of one channel. (player_audio_mixer_channel_t)
    #   amplitude: 0: silent, to 1: full volume.
    #   active: Off: muted.
    #   index: Index of the channel.
    struct MixerChannel {
        amplitude float32
        active common.Bool
        index uint32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RIuIu amplitude active.state index
        incr at 12
        set active.state [low 0xff ${active.state}]
        return [dict create amplitude $amplitude active [dict create state ${active.state}] index $index]
    } {
        append out [put float32 [dict get $value amplitude]]
        append out [common::Bool.write [dict get $value active]]
        append out [put uint32 [dict get $value index]]
        return $out
    }

    # Levels of some channels. (player_audio_mixer_channel_list_t)
    struct MixerChannelList {
        channels audio.MixerChannel[]
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu channels.count
        incr at 4
        set channels {}
        for {set channels.left [length $body channels ${channels.count} 12]} {${channels.left} > 0} {incr channels.left -1} {
            lappend channels [MixerChannel.read $body]
        }
        return [dict create channels $channels]
    } {
        append out [count channels [llength [dict get $value channels]] 2796199]
        append out [count channels [llength [dict get $value channels]] 2796199]
        foreach item [dict get $value channels] {append out [MixerChannel.write $item]}
        return $out
    }

    # Description of a channel. (player_audio_mixer_channel_detail_t)
    #   caps: Input, output or special.
    struct MixerChannelDetail {
        name char[]
        caps uint8
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu name.count
        incr at 4
        set name [opaque $body [length $body name ${name.count} 1]]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu caps
        incr at 4
        set caps [low 0xff $caps]
        return [dict create name $name caps $caps]
    } {
        append out [count name [string length [dict get $value name]] 33554392]
        append out [count name [string length [dict get $value name]] 33554392]
        append out [pad name [dict get $value name]]
        append out [put uint8 [dict get $value caps]]
        return $out
    }

    # List of channels. (player_audio_mixer_channel_list_detail_t)
    #   default_output: Index of the channel that plays; -1 none.
    #   default_input: Index of the channel that records; -1 none.
    struct MixerChannelListDetail {
        details audio.MixerChannelDetail[]
        default_output int32
        default_input int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu details.count
        incr at 4
        set details {}
        for {set details.left [length $body details ${details.count} 12]} {${details.left} > 0} {incr details.left -1} {
            lappend details [MixerChannelDetail.read $body]
        }
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}II default_output default_input
        incr at 8
        return [dict create details $details default_output $default_output default_input $default_input]
    } {
        append out [count details [llength [dict get $value details]] 2796199]
        append out [count details [llength [dict get $value details]] 2796199]
        foreach item [dict get $value details] {append out [MixerChannelDetail.write $item]}
        append out [put int32 [dict get $value default_output]]
        append out [put int32 [dict get $value default_input]]
        return $out
    }

    # A sample and its index in the store. (player_audio_sample_t)
    #   index: Index in the store; -1: chosen by the driver when loading.
    struct Sample {
        sample audio.Wav
        index int32
    } {
        set sample [Wav.read $body]
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I index
        incr at 4
        return [dict create sample $sample index $index]
    } {
        append out [Wav.write [dict get $value sample]]
        append out [put int32 [dict get $value index]]
        return $out
    }

    # An index in the store. (player_audio_sample_item_t)
    struct SampleItem {
        index int32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}I index
        incr at 4
        return [dict create index $index]
    } {
        append out [put int32 [dict get $value index]]
        return $out
    }

    # Request to record into the store. (player_audio_sample_rec_req_t)
    #   index: Index in the store; -1: chosen by the driver.
    #   length: in ms.
    struct SampleRecReq {
        index int32
        length uint32
    } {
        if {[string length $body] - $at < 8} {cut $body $at {4 4}}
        binary scan $body @${at}IIu index length
        incr at 8
        return [dict create index $index length $length]
    } {
        append out [put int32 [dict get $value index]]
        append out [put uint32 [dict get $value length]]
        return $out
    }

    # State of the device. (player_audio_state_t)
    #   state: Playing, recording, both or neither.
    struct State {
        state uint32
    } {
        if {[string length $body] - $at < 4} {cut $body $at {4}}
        binary scan $body @${at}Iu state
        incr at 4
        return [dict create state $state]
    } {
        append out [put uint32 [dict get $value state]]
        return $out
    }

    # Recorded sound.
    message audio.data.wav_rec DATA 1 audio.Wav
    # Detected tones.
    message audio.data.seq DATA 2 audio.Seq
    # Levels of the mixer, sent on change.
    message audio.data.mixer_channel DATA 3 audio.MixerChannelList
    # State of the device.
    message audio.data.state DATA 4 audio.State
    # Plays sound.
    message audio.cmd.wav_play CMD 1 audio.Wav
    # Starts or stops sending recorded sound.
    message audio.cmd.wav_stream_rec CMD 2 common.Bool
    # Plays a stored sample.
    message audio.cmd.sample_play CMD 3 audio.SampleItem
    # Plays tones.
    message audio.cmd.seq_play CMD 4 audio.Seq
    # Sets levels of the mixer.
    message audio.cmd.mixer_channel CMD 5 audio.MixerChannelList
    # Records sound.
    message audio.req.wav_rec REQ 1 audio.Wav
    # Stores a sample.
    message audio.req.sample_load REQ 2 audio.Sample
    # Fetches a stored sample.
    message audio.req.sample_retrieve REQ 3 audio.Sample
    # Records a sample into the store.
    message audio.req.sample_rec REQ 4 audio.SampleItem
    # Requests the channels of the mixer.
    message audio.req.mixer_channel_list REQ 5 audio.MixerChannelListDetail
    # Requests the levels of the mixer.
    message audio.req.mixer_channel_level REQ 6 audio.MixerChannelList
}
