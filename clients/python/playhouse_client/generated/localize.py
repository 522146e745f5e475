"""Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose.

Generated from interfaces/025_localize.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 25


@dataclass
class Hypoth(Struct):
    """A hypothesis. (player_localize_hypoth_t)"""

    # Mean of the hypothesis (in m, m, rad, frame X_MR).
    mean: common.Pose2d = field(default_factory=common.Pose2d)
    # Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
    cov: List[float] = field(default_factory=lambda: [0.0 for _ in range(6)])
    # Weight; the weights sum to 1.
    alpha: float = 0.0

    def write(self, writer: Writer) -> None:
        self.mean.write(writer)
        writer.exactly("cov", len(self.cov), 6)
        writer.numbers("d", self.cov)
        writer.number("d", self.alpha)

    @classmethod
    def read(cls, reader: Reader) -> "Hypoth":
        self = cls()
        self.mean = common.Pose2d.read(reader)
        self.cov = reader.numbers("d", 6)
        self.alpha = reader.number("d")
        return self


@dataclass
class Data(Struct):
    """The hypotheses. (player_localize_data_t)"""

    # Number of queued sensor readings.
    pending_count: int = 0
    # Time of the last processed reading (in s).
    pending_time: float = 0.0
    hypoths: List[Hypoth] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.number("I", self.pending_count)
        writer.number("d", self.pending_time)
        writer.length("hypoths", len(self.hypoths), 419429)
        writer.length("hypoths", len(self.hypoths), 419429)
        for item in self.hypoths:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.pending_count = reader.number("I")
        self.pending_time = reader.number("d")
        hypoths_count = reader.number("I")
        hypoths_length = reader.length("hypoths", hypoths_count, 80)
        self.hypoths = [Hypoth.read(reader) for _ in range(hypoths_length)]
        return self


@dataclass
class SetPose(Struct):
    """Pose of the robot. (player_localize_set_pose_t)"""

    # Mean of the hypothesis (in m, m, rad, frame X_MR).
    mean: common.Pose2d = field(default_factory=common.Pose2d)
    # Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad).
    cov: List[float] = field(default_factory=lambda: [0.0 for _ in range(6)])

    def write(self, writer: Writer) -> None:
        self.mean.write(writer)
        writer.exactly("cov", len(self.cov), 6)
        writer.numbers("d", self.cov)

    @classmethod
    def read(cls, reader: Reader) -> "SetPose":
        self = cls()
        self.mean = common.Pose2d.read(reader)
        self.cov = reader.numbers("d", 6)
        return self


@dataclass
class Particle(Struct):
    """One particle. (player_localize_particle_t)"""

    # The particle's estimate of the robot's pose (in m, m, rad, frame X_MR).
    pose: common.Pose2d = field(default_factory=common.Pose2d)
    # Weight.
    alpha: float = 0.0

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        writer.number("d", self.alpha)

    @classmethod
    def read(cls, reader: Reader) -> "Particle":
        self = cls()
        self.pose = common.Pose2d.read(reader)
        self.alpha = reader.number("d")
        return self


@dataclass
class GetParticles(Struct):
    """The particles of the filter. (player_localize_get_particles_t)"""

    # Of the most likely hypothesis (in m, m, rad, frame X_MR).
    mean: common.Pose2d = field(default_factory=common.Pose2d)
    # Of the most likely hypothesis (in m^2).
    variance: float = 0.0
    particles: List[Particle] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        self.mean.write(writer)
        writer.number("d", self.variance)
        writer.length("particles", len(self.particles), 1048574)
        writer.length("particles", len(self.particles), 1048574)
        for item in self.particles:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "GetParticles":
        self = cls()
        self.mean = common.Pose2d.read(reader)
        self.variance = reader.number("d")
        particles_count = reader.number("I")
        particles_length = reader.length("particles", particles_count, 32)
        self.particles = [Particle.read(reader) for _ in range(particles_length)]
        return self


# The hypotheses, the most likely first.
DATA_HYPOTHS = MessageType(25, Kind.DATA, 1, "localize.data.hypoths", Data)
# Sets the robot's pose estimate.
REQ_SET_POSE = MessageType(25, Kind.REQ, 1, "localize.req.set_pose", SetPose)
# Requests the particles of the driver's filter.
REQ_GET_PARTICLES = MessageType(25, Kind.REQ, 2, "localize.req.get_particles", GetParticles)
