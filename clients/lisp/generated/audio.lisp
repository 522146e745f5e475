;;;; Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels.
;;;;
;;;; Generated from interfaces/009_audio.toml by codegen; do not edit.

(cl:defpackage #:playhouse.audio
  (:use)
  (:import-from #:playhouse.wire #:define-constants #:define-interface #:define-message #:define-struct)
  (:export #:+code+ #:+state-stopped+ #:+state-playing+ #:+state-recording+ #:+description-bits+ #:+bits+
           #:+8bit+ #:+16bit+ #:+24bit+ #:+mono+ #:+stereo+ #:+freq+ #:+freq-44k+ #:+freq-11k+ #:+freq-22k+
           #:+freq-48k+ #:+format-bits+ #:+format-null+ #:+format-raw+ #:+format-mp3+ #:+format-ogg+
           #:+format-flac+ #:+format-aac+ #:+mixer-channel-type-input+ #:+mixer-channel-type-output+
           #:+mixer-channel-type-special+ #:+data-wav-rec+ #:+data-seq+ #:+data-mixer-channel+
           #:+data-state+ #:+cmd-wav-play+ #:+cmd-wav-stream-rec+ #:+cmd-sample-play+ #:+cmd-seq-play+
           #:+cmd-mixer-channel+ #:+req-wav-rec+ #:+req-sample-load+ #:+req-sample-retrieve+
           #:+req-sample-rec+ #:+req-mixer-channel-list+ #:+req-mixer-channel-level+ #:wav #:seq-item #:seq
           #:mixer-channel #:mixer-channel-list #:mixer-channel-detail #:mixer-channel-list-detail #:sample
           #:sample-item #:sample-rec-req #:state #:make-wav #:copy-wav #:wav-p #:wav-data #:wav-format
           #:make-seq-item #:copy-seq-item #:seq-item-p #:seq-item-freq #:seq-item-duration
           #:seq-item-amplitude #:seq-item-link #:make-seq #:copy-seq #:seq-p #:seq-tones
           #:make-mixer-channel #:copy-mixer-channel #:mixer-channel-p #:mixer-channel-amplitude
           #:mixer-channel-active #:mixer-channel-index #:make-mixer-channel-list #:copy-mixer-channel-list
           #:mixer-channel-list-p #:mixer-channel-list-channels #:make-mixer-channel-detail
           #:copy-mixer-channel-detail #:mixer-channel-detail-p #:mixer-channel-detail-name
           #:mixer-channel-detail-caps #:make-mixer-channel-list-detail #:copy-mixer-channel-list-detail
           #:mixer-channel-list-detail-p #:mixer-channel-list-detail-details
           #:mixer-channel-list-detail-default-output #:mixer-channel-list-detail-default-input
           #:make-sample #:copy-sample #:sample-p #:sample-sample #:sample-index #:make-sample-item
           #:copy-sample-item #:sample-item-p #:sample-item-index #:make-sample-rec-req
           #:copy-sample-rec-req #:sample-rec-req-p #:sample-rec-req-index #:sample-rec-req-length
           #:make-state #:copy-state #:state-p #:state-state))

(cl:in-package #:playhouse.audio)

(define-interface +code+ 9 "audio")

;;; Bits of State.state.
(define-constants
  (+state-stopped+ 0)
  (+state-playing+ 1)
  (+state-recording+ 2))

;;; Mask of the bits of Wav.format that describe raw sound.
(define-constants
  (+description-bits+ 255))

;;; Bits per value of raw sound: mask and values.
(define-constants
  (+bits+ 3)
  (+8bit+ 0)
  (+16bit+ 1)
  (+24bit+ 2))

;;; Channels of raw sound.
(define-constants
  (+mono+ 0)
  (+stereo+ 4))

;;; Sampling rate of raw sound: mask and values.
(define-constants
  (+freq+ 24)
  (+freq-44k+ 0)
  (+freq-11k+ 8)
  (+freq-22k+ 16)
  (+freq-48k+ 24))

;;; Kind of sound data: mask and values.
(define-constants
  (+format-bits+ 65280)
  (+format-null+ 0)
  (+format-raw+ 256)
  (+format-mp3+ 512)
  (+format-ogg+ 768)
  (+format-flac+ 1024)
  (+format-aac+ 1280))

;;; Bits of MixerChannelDetail.caps.
(define-constants
  (+mixer-channel-type-input+ 1)
  (+mixer-channel-type-output+ 2)
  (+mixer-channel-type-special+ 4))

(define-struct (wav "audio.Wav")
  "A sound. (player_audio_wav_t)"
  ;; The sound, in the format of `format`.
  (data "data" (:counted :uint8 33554392))
  ;; Kind, rate, channels and bits in one number.
  (format "format" :uint32))

(define-struct (seq-item "audio.SeqItem")
  "One tone. (player_audio_seq_item_t)"
  ;; In Hz.
  (freq "freq" :float32)
  ;; In s.
  (duration "duration" :float32)
  ;; 0: silent, to 1: full volume.
  (amplitude "amplitude" :float32)
  ;; On: joined to the next tone without a gap.
  (link "link" playhouse.common:bool))

(define-struct (seq "audio.Seq")
  "A sequence of tones. (player_audio_seq_t)"
  (tones "tones" (:counted seq-item 2097149 16)))

(define-struct (mixer-channel "audio.MixerChannel")
  "Level of one channel. (player_audio_mixer_channel_t)"
  ;; 0: silent, to 1: full volume.
  (amplitude "amplitude" :float32)
  ;; Off: muted.
  (active "active" playhouse.common:bool)
  ;; Index of the channel.
  (index "index" :uint32))

(define-struct (mixer-channel-list "audio.MixerChannelList")
  "Levels of some channels. (player_audio_mixer_channel_list_t)"
  (channels "channels" (:counted mixer-channel 2796199 12)))

(define-struct (mixer-channel-detail "audio.MixerChannelDetail")
  "Description of a channel. (player_audio_mixer_channel_detail_t)"
  (name "name" (:counted :char 33554392))
  ;; Input, output or special.
  (caps "caps" :uint8))

(define-struct (mixer-channel-list-detail "audio.MixerChannelListDetail")
  "List of channels. (player_audio_mixer_channel_list_detail_t)"
  (details "details" (:counted mixer-channel-detail 2796199 12))
  ;; Index of the channel that plays; -1 none.
  (default-output "default_output" :int32)
  ;; Index of the channel that records; -1 none.
  (default-input "default_input" :int32))

(define-struct (sample "audio.Sample")
  "A sample and its index in the store. (player_audio_sample_t)"
  (sample "sample" wav)
  ;; Index in the store; -1: chosen by the driver when loading.
  (index "index" :int32))

(define-struct (sample-item "audio.SampleItem")
  "An index in the store. (player_audio_sample_item_t)"
  (index "index" :int32))

(define-struct (sample-rec-req "audio.SampleRecReq")
  "Request to record into the store. (player_audio_sample_rec_req_t)"
  ;; Index in the store; -1: chosen by the driver.
  (index "index" :int32)
  ;; In ms.
  (length "length" :uint32))

(define-struct (state "audio.State")
  "State of the device. (player_audio_state_t)"
  ;; Playing, recording, both or neither.
  (state "state" :uint32))

;; Recorded sound.
(define-message +data-wav-rec+ 9 :data 1 "audio.data.wav_rec" wav)
;; Detected tones.
(define-message +data-seq+ 9 :data 2 "audio.data.seq" seq)
;; Levels of the mixer, sent on change.
(define-message +data-mixer-channel+ 9 :data 3 "audio.data.mixer_channel" mixer-channel-list)
;; State of the device.
(define-message +data-state+ 9 :data 4 "audio.data.state" state)
;; Plays sound.
(define-message +cmd-wav-play+ 9 :cmd 1 "audio.cmd.wav_play" wav)
;; Starts or stops sending recorded sound.
(define-message +cmd-wav-stream-rec+ 9 :cmd 2 "audio.cmd.wav_stream_rec" playhouse.common:bool)
;; Plays a stored sample.
(define-message +cmd-sample-play+ 9 :cmd 3 "audio.cmd.sample_play" sample-item)
;; Plays tones.
(define-message +cmd-seq-play+ 9 :cmd 4 "audio.cmd.seq_play" seq)
;; Sets levels of the mixer.
(define-message +cmd-mixer-channel+ 9 :cmd 5 "audio.cmd.mixer_channel" mixer-channel-list)
;; Records sound.
(define-message +req-wav-rec+ 9 :req 1 "audio.req.wav_rec" wav)
;; Stores a sample.
(define-message +req-sample-load+ 9 :req 2 "audio.req.sample_load" sample)
;; Fetches a stored sample.
(define-message +req-sample-retrieve+ 9 :req 3 "audio.req.sample_retrieve" sample)
;; Records a sample into the store.
(define-message +req-sample-rec+ 9 :req 4 "audio.req.sample_rec" sample-item)
;; Requests the channels of the mixer.
(define-message +req-mixer-channel-list+ 9 :req 5 "audio.req.mixer_channel_list" mixer-channel-list-detail)
;; Requests the levels of the mixer.
(define-message +req-mixer-channel-level+ 9 :req 6 "audio.req.mixer_channel_level" mixer-channel-list)
