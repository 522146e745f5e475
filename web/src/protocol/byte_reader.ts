const kDecoder = new TextDecoder('utf-8', { fatal: true });

/** Decoder of packets; throws RangeError beyond the end, TypeError on invalid UTF-8. Format: playhouse/replicate/delta.h. */
export class ByteReader {
  private at = 0;
  private readonly view: DataView;

  constructor(bytes: ArrayBuffer) {
    this.view = new DataView(bytes);
  }

  /** Bytes that are not read yet. */
  get left(): number {
    return this.view.byteLength - this.at;
  }

  get atEnd(): boolean {
    return this.at === this.view.byteLength;
  }

  u8(): number {
    return this.view.getUint8(this.at++);
  }

  u16(): number {
    const value = this.view.getUint16(this.at, true);
    this.at += 2;
    return value;
  }

  u32(): number {
    const value = this.view.getUint32(this.at, true);
    this.at += 4;
    return value;
  }

  f32(): number {
    const value = this.view.getFloat32(this.at, true);
    this.at += 4;
    return value;
  }

  /** Up to 2^53: multiplied, as JavaScript's shifts are 32-bit. */
  varint(): number {
    let value = 0;
    let scale = 1;
    for (;;) {
      const byte = this.u8();
      value += (byte & 0x7f) * scale;
      if (byte < 0x80) return value;
      scale *= 128;
      if (scale > 2 ** 56) throw new RangeError('a number without end');
    }
  }

  /** Length-prefixed UTF-8. */
  text(): string {
    const length = this.varint();
    if (length > this.view.byteLength - this.at) throw new RangeError('a text without end');
    const bytes = new Uint8Array(this.view.buffer, this.at, length);
    this.at += length;
    return kDecoder.decode(bytes);
  }

  zigzag(): number {
    const value = this.varint();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }
}
