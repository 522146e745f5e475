// Generated from interfaces/009_audio.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels. */
public final class AudioMessages {
  /** The interface's code. */
  public static final int CODE = 9;

  // Bits of State.state.
  public static final int STATE_STOPPED = 0;
  public static final int STATE_PLAYING = 1;
  public static final int STATE_RECORDING = 2;

  // Mask of the bits of Wav.format that describe raw sound.
  public static final int DESCRIPTION_BITS = 255;

  // Bits per value of raw sound: mask and values.
  public static final int BITS = 3;
  public static final int AUDIO_8BIT = 0;
  public static final int AUDIO_16BIT = 1;
  public static final int AUDIO_24BIT = 2;

  // Channels of raw sound.
  public static final int MONO = 0;
  public static final int STEREO = 4;

  // Sampling rate of raw sound: mask and values.
  public static final int FREQ = 24;
  public static final int FREQ_44k = 0;
  public static final int FREQ_11k = 8;
  public static final int FREQ_22k = 16;
  public static final int FREQ_48k = 24;

  // Kind of sound data: mask and values.
  public static final int FORMAT_BITS = 65280;
  public static final int FORMAT_NULL = 0;
  public static final int FORMAT_RAW = 256;
  public static final int FORMAT_MP3 = 512;
  public static final int FORMAT_OGG = 768;
  public static final int FORMAT_FLAC = 1024;
  public static final int FORMAT_AAC = 1280;

  // Bits of MixerChannelDetail.caps.
  public static final int MIXER_CHANNEL_TYPE_INPUT = 1;
  public static final int MIXER_CHANNEL_TYPE_OUTPUT = 2;
  public static final int MIXER_CHANNEL_TYPE_SPECIAL = 4;

  /**
   * A sound. (player_audio_wav_t)
   *
   * @param data The sound, in the format of `format`.
   * @param format Kind, rate, channels and bits in one number.
   */
  public record Wav(byte[] data, long format) implements Struct {
    /** Every number 0, every list empty. */
    public Wav() {
      this(new byte[0], 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Wav decode(byte[] body) {
      return Reader.decode("audio.Wav", body, Wav::read);
    }

    static Wav read(Reader in) {
      long dataCount = in.uint32();
      byte[] data = in.bytes(in.length("data", dataCount, 1));
      long format = in.uint32();
      return new Wav(data, format);
    }

    @Override
    public void write(Writer out) {
      out.length("data", data.length, 33554392);
      out.length("data", data.length, 33554392);
      out.bytes(data);
      out.uint32(format);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Wav that && Arrays.equals(data, that.data) && format == that.format;
    }

    @Override
    public int hashCode() {
      return Objects.hash(format, Arrays.hashCode(data));
    }
  }

  /**
   * One tone. (player_audio_seq_item_t)
   *
   * @param freq In Hz.
   * @param duration In s.
   * @param amplitude 0: silent, to 1: full volume.
   * @param link On: joined to the next tone without a gap.
   */
  public record SeqItem(
      float freq, float duration, float amplitude, CommonMessages.Bool link)
      implements Struct {
    /** Every number 0, every list empty. */
    public SeqItem() {
      this(0f, 0f, 0f, new CommonMessages.Bool());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SeqItem decode(byte[] body) {
      return Reader.decode("audio.SeqItem", body, SeqItem::read);
    }

    static SeqItem read(Reader in) {
      float freq = in.float32();
      float duration = in.float32();
      float amplitude = in.float32();
      CommonMessages.Bool link = CommonMessages.Bool.read(in);
      return new SeqItem(freq, duration, amplitude, link);
    }

    @Override
    public void write(Writer out) {
      out.float32(freq);
      out.float32(duration);
      out.float32(amplitude);
      link.write(out);
    }
  }

  /**
   * A sequence of tones. (player_audio_seq_t)
   *
   * @param tones Tones.
   */
  public record Seq(List<SeqItem> tones) implements Struct {
    /** Every number 0, every list empty. */
    public Seq() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Seq decode(byte[] body) {
      return Reader.decode("audio.Seq", body, Seq::read);
    }

    static Seq read(Reader in) {
      long tonesCount = in.uint32();
      List<SeqItem> tones = in.structs(in.length("tones", tonesCount, 16), SeqItem::read);
      return new Seq(tones);
    }

    @Override
    public void write(Writer out) {
      out.length("tones", tones.size(), 2097149);
      out.length("tones", tones.size(), 2097149);
      out.structs(tones);
    }
  }

  /**
   * Level of one channel. (player_audio_mixer_channel_t)
   *
   * @param amplitude 0: silent, to 1: full volume.
   * @param active Off: muted.
   * @param index Index of the channel.
   */
  public record MixerChannel(float amplitude, CommonMessages.Bool active, long index) implements Struct {
    /** Every number 0, every list empty. */
    public MixerChannel() {
      this(0f, new CommonMessages.Bool(), 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MixerChannel decode(byte[] body) {
      return Reader.decode("audio.MixerChannel", body, MixerChannel::read);
    }

    static MixerChannel read(Reader in) {
      float amplitude = in.float32();
      CommonMessages.Bool active = CommonMessages.Bool.read(in);
      long index = in.uint32();
      return new MixerChannel(amplitude, active, index);
    }

    @Override
    public void write(Writer out) {
      out.float32(amplitude);
      active.write(out);
      out.uint32(index);
    }
  }

  /**
   * Levels of some channels. (player_audio_mixer_channel_list_t)
   *
   * @param channels Channels.
   */
  public record MixerChannelList(List<MixerChannel> channels) implements Struct {
    /** Every number 0, every list empty. */
    public MixerChannelList() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MixerChannelList decode(byte[] body) {
      return Reader.decode("audio.MixerChannelList", body, MixerChannelList::read);
    }

    static MixerChannelList read(Reader in) {
      long channelsCount = in.uint32();
      List<MixerChannel> channels = in.structs(in.length("channels", channelsCount, 12), MixerChannel::read);
      return new MixerChannelList(channels);
    }

    @Override
    public void write(Writer out) {
      out.length("channels", channels.size(), 2796199);
      out.length("channels", channels.size(), 2796199);
      out.structs(channels);
    }
  }

  /**
   * Description of a channel. (player_audio_mixer_channel_detail_t)
   *
   * @param name Name.
   * @param caps Input, output or special.
   */
  public record MixerChannelDetail(byte[] name, int caps) implements Struct {
    /** Every number 0, every list empty. */
    public MixerChannelDetail() {
      this(new byte[0], 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MixerChannelDetail decode(byte[] body) {
      return Reader.decode("audio.MixerChannelDetail", body, MixerChannelDetail::read);
    }

    static MixerChannelDetail read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      int caps = in.uint8();
      return new MixerChannelDetail(name, caps);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      out.uint8(caps);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof MixerChannelDetail that && Arrays.equals(name, that.name) && caps == that.caps;
    }

    @Override
    public int hashCode() {
      return Objects.hash(caps, Arrays.hashCode(name));
    }
  }

  /**
   * List of channels. (player_audio_mixer_channel_list_detail_t)
   *
   * @param details Details.
   * @param defaultOutput Index of the channel that plays; -1 none.
   * @param defaultInput Index of the channel that records; -1 none.
   */
  public record MixerChannelListDetail(
      List<MixerChannelDetail> details, int defaultOutput, int defaultInput)
      implements Struct {
    /** Every number 0, every list empty. */
    public MixerChannelListDetail() {
      this(List.of(), 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MixerChannelListDetail decode(byte[] body) {
      return Reader.decode("audio.MixerChannelListDetail", body, MixerChannelListDetail::read);
    }

    static MixerChannelListDetail read(Reader in) {
      long detailsCount = in.uint32();
      List<MixerChannelDetail> details = in.structs(in.length("details", detailsCount, 12),
          MixerChannelDetail::read);
      int defaultOutput = in.int32();
      int defaultInput = in.int32();
      return new MixerChannelListDetail(details, defaultOutput, defaultInput);
    }

    @Override
    public void write(Writer out) {
      out.length("details", details.size(), 2796199);
      out.length("details", details.size(), 2796199);
      out.structs(details);
      out.int32(defaultOutput);
      out.int32(defaultInput);
    }
  }

  /**
   * A sample and its index in the store. (player_audio_sample_t)
   *
   * @param sample Sample.
   * @param index Index in the store; -1: chosen by the driver when loading.
   */
  public record Sample(Wav sample, int index) implements Struct {
    /** Every number 0, every list empty. */
    public Sample() {
      this(new Wav(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Sample decode(byte[] body) {
      return Reader.decode("audio.Sample", body, Sample::read);
    }

    static Sample read(Reader in) {
      Wav sample = Wav.read(in);
      int index = in.int32();
      return new Sample(sample, index);
    }

    @Override
    public void write(Writer out) {
      sample.write(out);
      out.int32(index);
    }
  }

  /**
   * An index in the store. (player_audio_sample_item_t)
   *
   * @param index Index.
   */
  public record SampleItem(int index) implements Struct {
    /** Every number 0, every list empty. */
    public SampleItem() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SampleItem decode(byte[] body) {
      return Reader.decode("audio.SampleItem", body, SampleItem::read);
    }

    static SampleItem read(Reader in) {
      int index = in.int32();
      return new SampleItem(index);
    }

    @Override
    public void write(Writer out) {
      out.int32(index);
    }
  }

  /**
   * Request to record into the store. (player_audio_sample_rec_req_t)
   *
   * @param index Index in the store; -1: chosen by the driver.
   * @param length In ms.
   */
  public record SampleRecReq(int index, long length) implements Struct {
    /** Every number 0, every list empty. */
    public SampleRecReq() {
      this(0, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SampleRecReq decode(byte[] body) {
      return Reader.decode("audio.SampleRecReq", body, SampleRecReq::read);
    }

    static SampleRecReq read(Reader in) {
      int index = in.int32();
      long length = in.uint32();
      return new SampleRecReq(index, length);
    }

    @Override
    public void write(Writer out) {
      out.int32(index);
      out.uint32(length);
    }
  }

  /**
   * State of the device. (player_audio_state_t)
   *
   * @param state Playing, recording, both or neither.
   */
  public record State(long state) implements Struct {
    /** Every number 0, every list empty. */
    public State() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static State decode(byte[] body) {
      return Reader.decode("audio.State", body, State::read);
    }

    static State read(Reader in) {
      long state = in.uint32();
      return new State(state);
    }

    @Override
    public void write(Writer out) {
      out.uint32(state);
    }
  }

  /** Recorded sound. */
  public static final MessageType<Wav> DATA_WAV_REC =
      new MessageType<>(9, Kind.DATA, 1, "audio.data.wav_rec", Wav::decode);

  /** Detected tones. */
  public static final MessageType<Seq> DATA_SEQ =
      new MessageType<>(9, Kind.DATA, 2, "audio.data.seq", Seq::decode);

  /** Levels of the mixer, sent on change. */
  public static final MessageType<MixerChannelList> DATA_MIXER_CHANNEL =
      new MessageType<>(9, Kind.DATA, 3, "audio.data.mixer_channel", MixerChannelList::decode);

  /** State of the device. */
  public static final MessageType<State> DATA_STATE =
      new MessageType<>(9, Kind.DATA, 4, "audio.data.state", State::decode);

  /** Plays sound. */
  public static final MessageType<Wav> CMD_WAV_PLAY =
      new MessageType<>(9, Kind.CMD, 1, "audio.cmd.wav_play", Wav::decode);

  /** Starts or stops sending recorded sound. */
  public static final MessageType<CommonMessages.Bool> CMD_WAV_STREAM_REC =
      new MessageType<>(9, Kind.CMD, 2, "audio.cmd.wav_stream_rec", CommonMessages.Bool::decode);

  /** Plays a stored sample. */
  public static final MessageType<SampleItem> CMD_SAMPLE_PLAY =
      new MessageType<>(9, Kind.CMD, 3, "audio.cmd.sample_play", SampleItem::decode);

  /** Plays tones. */
  public static final MessageType<Seq> CMD_SEQ_PLAY =
      new MessageType<>(9, Kind.CMD, 4, "audio.cmd.seq_play", Seq::decode);

  /** Sets levels of the mixer. */
  public static final MessageType<MixerChannelList> CMD_MIXER_CHANNEL =
      new MessageType<>(9, Kind.CMD, 5, "audio.cmd.mixer_channel", MixerChannelList::decode);

  /** Records sound. */
  public static final MessageType<Wav> REQ_WAV_REC =
      new MessageType<>(9, Kind.REQ, 1, "audio.req.wav_rec", Wav::decode);

  /** Stores a sample. */
  public static final MessageType<Sample> REQ_SAMPLE_LOAD =
      new MessageType<>(9, Kind.REQ, 2, "audio.req.sample_load", Sample::decode);

  /** Fetches a stored sample. */
  public static final MessageType<Sample> REQ_SAMPLE_RETRIEVE =
      new MessageType<>(9, Kind.REQ, 3, "audio.req.sample_retrieve", Sample::decode);

  /** Records a sample into the store. */
  public static final MessageType<SampleItem> REQ_SAMPLE_REC =
      new MessageType<>(9, Kind.REQ, 4, "audio.req.sample_rec", SampleItem::decode);

  /** Requests the channels of the mixer. */
  public static final MessageType<MixerChannelListDetail> REQ_MIXER_CHANNEL_LIST =
      new MessageType<>(9, Kind.REQ, 5, "audio.req.mixer_channel_list", MixerChannelListDetail::decode);

  /** Requests the levels of the mixer. */
  public static final MessageType<MixerChannelList> REQ_MIXER_CHANNEL_LEVEL =
      new MessageType<>(9, Kind.REQ, 6, "audio.req.mixer_channel_level", MixerChannelList::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_WAV_REC, DATA_SEQ, DATA_MIXER_CHANNEL, DATA_STATE, CMD_WAV_PLAY, CMD_WAV_STREAM_REC,
      CMD_SAMPLE_PLAY, CMD_SEQ_PLAY, CMD_MIXER_CHANNEL, REQ_WAV_REC, REQ_SAMPLE_LOAD, REQ_SAMPLE_RETRIEVE,
      REQ_SAMPLE_REC, REQ_MIXER_CHANNEL_LIST, REQ_MIXER_CHANNEL_LEVEL);

  private AudioMessages() {}
}
