"""Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels.

Generated from interfaces/009_audio.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 9

# Bits of State.state.
STATE_STOPPED = 0
STATE_PLAYING = 1
STATE_RECORDING = 2

# Mask of the bits of Wav.format that describe raw sound.
DESCRIPTION_BITS = 255

# Bits per value of raw sound: mask and values.
BITS = 3
AUDIO_8BIT = 0
AUDIO_16BIT = 1
AUDIO_24BIT = 2

# Channels of raw sound.
MONO = 0
STEREO = 4

# Sampling rate of raw sound: mask and values.
FREQ = 24
FREQ_44k = 0
FREQ_11k = 8
FREQ_22k = 16
FREQ_48k = 24

# Kind of sound data: mask and values.
FORMAT_BITS = 65280
FORMAT_NULL = 0
FORMAT_RAW = 256
FORMAT_MP3 = 512
FORMAT_OGG = 768
FORMAT_FLAC = 1024
FORMAT_AAC = 1280

# Bits of MixerChannelDetail.caps.
MIXER_CHANNEL_TYPE_INPUT = 1
MIXER_CHANNEL_TYPE_OUTPUT = 2
MIXER_CHANNEL_TYPE_SPECIAL = 4


@dataclass
class Wav(Struct):
    """A sound. (player_audio_wav_t)"""

    # The sound, in the format of `format`.
    data: bytes = b""
    # Kind, rate, channels and bits in one number.
    format: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("data", len(self.data), 33554392)
        writer.length("data", len(self.data), 33554392)
        writer.opaque(self.data)
        writer.number("I", self.format)

    @classmethod
    def read(cls, reader: Reader) -> "Wav":
        self = cls()
        data_count = reader.number("I")
        self.data = reader.opaque(reader.length("data", data_count, 1))
        self.format = reader.number("I")
        return self


@dataclass
class SeqItem(Struct):
    """One tone. (player_audio_seq_item_t)"""

    # In Hz.
    freq: float = 0.0
    # In s.
    duration: float = 0.0
    # 0: silent, to 1: full volume.
    amplitude: float = 0.0
    # On: joined to the next tone without a gap.
    link: common.Bool = field(default_factory=common.Bool)

    def write(self, writer: Writer) -> None:
        writer.number("f", self.freq)
        writer.number("f", self.duration)
        writer.number("f", self.amplitude)
        self.link.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "SeqItem":
        self = cls()
        self.freq = reader.number("f")
        self.duration = reader.number("f")
        self.amplitude = reader.number("f")
        self.link = common.Bool.read(reader)
        return self


@dataclass
class Seq(Struct):
    """A sequence of tones. (player_audio_seq_t)"""

    tones: List[SeqItem] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("tones", len(self.tones), 2097149)
        writer.length("tones", len(self.tones), 2097149)
        for item in self.tones:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Seq":
        self = cls()
        tones_count = reader.number("I")
        tones_length = reader.length("tones", tones_count, 16)
        self.tones = [SeqItem.read(reader) for _ in range(tones_length)]
        return self


@dataclass
class MixerChannel(Struct):
    """Level of one channel. (player_audio_mixer_channel_t)"""

    # 0: silent, to 1: full volume.
    amplitude: float = 0.0
    # Off: muted.
    active: common.Bool = field(default_factory=common.Bool)
    # Index of the channel.
    index: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.amplitude)
        self.active.write(writer)
        writer.number("I", self.index)

    @classmethod
    def read(cls, reader: Reader) -> "MixerChannel":
        self = cls()
        self.amplitude = reader.number("f")
        self.active = common.Bool.read(reader)
        self.index = reader.number("I")
        return self


@dataclass
class MixerChannelList(Struct):
    """Levels of some channels. (player_audio_mixer_channel_list_t)"""

    channels: List[MixerChannel] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("channels", len(self.channels), 2796199)
        writer.length("channels", len(self.channels), 2796199)
        for item in self.channels:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "MixerChannelList":
        self = cls()
        channels_count = reader.number("I")
        channels_length = reader.length("channels", channels_count, 12)
        self.channels = [MixerChannel.read(reader) for _ in range(channels_length)]
        return self


@dataclass
class MixerChannelDetail(Struct):
    """Description of a channel. (player_audio_mixer_channel_detail_t)"""

    name: bytes = b""
    # Input, output or special.
    caps: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        writer.number("B", self.caps)

    @classmethod
    def read(cls, reader: Reader) -> "MixerChannelDetail":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        self.caps = reader.number("B")
        return self


@dataclass
class MixerChannelListDetail(Struct):
    """List of channels. (player_audio_mixer_channel_list_detail_t)"""

    details: List[MixerChannelDetail] = field(default_factory=list)
    # Index of the channel that plays; -1 none.
    default_output: int = 0
    # Index of the channel that records; -1 none.
    default_input: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("details", len(self.details), 2796199)
        writer.length("details", len(self.details), 2796199)
        for item in self.details:
            item.write(writer)
        writer.number("i", self.default_output)
        writer.number("i", self.default_input)

    @classmethod
    def read(cls, reader: Reader) -> "MixerChannelListDetail":
        self = cls()
        details_count = reader.number("I")
        details_length = reader.length("details", details_count, 12)
        self.details = [MixerChannelDetail.read(reader) for _ in range(details_length)]
        self.default_output = reader.number("i")
        self.default_input = reader.number("i")
        return self


@dataclass
class Sample(Struct):
    """A sample and its index in the store. (player_audio_sample_t)"""

    sample: Wav = field(default_factory=Wav)
    # Index in the store; -1: chosen by the driver when loading.
    index: int = 0

    def write(self, writer: Writer) -> None:
        self.sample.write(writer)
        writer.number("i", self.index)

    @classmethod
    def read(cls, reader: Reader) -> "Sample":
        self = cls()
        self.sample = Wav.read(reader)
        self.index = reader.number("i")
        return self


@dataclass
class SampleItem(Struct):
    """An index in the store. (player_audio_sample_item_t)"""

    index: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.index)

    @classmethod
    def read(cls, reader: Reader) -> "SampleItem":
        self = cls()
        self.index = reader.number("i")
        return self


@dataclass
class SampleRecReq(Struct):
    """Request to record into the store. (player_audio_sample_rec_req_t)"""

    # Index in the store; -1: chosen by the driver.
    index: int = 0
    # In ms.
    length: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.index)
        writer.number("I", self.length)

    @classmethod
    def read(cls, reader: Reader) -> "SampleRecReq":
        self = cls()
        self.index = reader.number("i")
        self.length = reader.number("I")
        return self


@dataclass
class State(Struct):
    """State of the device. (player_audio_state_t)"""

    # Playing, recording, both or neither.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "State":
        self = cls()
        self.state = reader.number("I")
        return self


# Recorded sound.
DATA_WAV_REC = MessageType(9, Kind.DATA, 1, "audio.data.wav_rec", Wav)
# Detected tones.
DATA_SEQ = MessageType(9, Kind.DATA, 2, "audio.data.seq", Seq)
# Levels of the mixer, sent on change.
DATA_MIXER_CHANNEL = MessageType(9, Kind.DATA, 3, "audio.data.mixer_channel", MixerChannelList)
# State of the device.
DATA_STATE = MessageType(9, Kind.DATA, 4, "audio.data.state", State)
# Plays sound.
CMD_WAV_PLAY = MessageType(9, Kind.CMD, 1, "audio.cmd.wav_play", Wav)
# Starts or stops sending recorded sound.
CMD_WAV_STREAM_REC = MessageType(9, Kind.CMD, 2, "audio.cmd.wav_stream_rec", common.Bool)
# Plays a stored sample.
CMD_SAMPLE_PLAY = MessageType(9, Kind.CMD, 3, "audio.cmd.sample_play", SampleItem)
# Plays tones.
CMD_SEQ_PLAY = MessageType(9, Kind.CMD, 4, "audio.cmd.seq_play", Seq)
# Sets levels of the mixer.
CMD_MIXER_CHANNEL = MessageType(9, Kind.CMD, 5, "audio.cmd.mixer_channel", MixerChannelList)
# Records sound.
REQ_WAV_REC = MessageType(9, Kind.REQ, 1, "audio.req.wav_rec", Wav)
# Stores a sample.
REQ_SAMPLE_LOAD = MessageType(9, Kind.REQ, 2, "audio.req.sample_load", Sample)
# Fetches a stored sample.
REQ_SAMPLE_RETRIEVE = MessageType(9, Kind.REQ, 3, "audio.req.sample_retrieve", Sample)
# Records a sample into the store.
REQ_SAMPLE_REC = MessageType(9, Kind.REQ, 4, "audio.req.sample_rec", SampleItem)
# Requests the channels of the mixer.
REQ_MIXER_CHANNEL_LIST = MessageType(9, Kind.REQ, 5, "audio.req.mixer_channel_list", MixerChannelListDetail)
# Requests the levels of the mixer.
REQ_MIXER_CHANNEL_LEVEL = MessageType(9, Kind.REQ, 6, "audio.req.mixer_channel_level", MixerChannelList)
