# SPDX-License-Identifier: BSD-3-Clause
"""Clouds by themselves, for those who need no segments."""

from __future__ import annotations

from ._stream import join
from .lists import Reader
from .samples import Cloud
from .types import Kind


class Clouds(Reader[Cloud]):
    """The clouds of a sensor, whether or not they are segmented."""

    def _take(self, timeout_ms: int) -> Cloud | None:
        pointer = self._pointer_in_time(timeout_ms)
        return Cloud(pointer, self.stream) if pointer is not None else None

    def _silence(self) -> str:
        who = "its camera sends nothing" if self.writers else "nobody publishes its clouds"
        return (
            f"sensor '{self.sensor}' in domain {self.stream.domain}: {who}. Start its grabber, or "
            "see `cleave status` for what runs"
        )


def clouds(
    sensor: str = "camera",
    *,
    timeout: float | None = None,
    domain: int | None = None,
    shared_memory: bool | None = None,
) -> Clouds:
    """An iterator, plain or asynchronous, over the clouds of a sensor; `cloud.points` is in place.
    Options as frames() has them. Hold few: each is a chunk of the camera's memory."""
    return Clouds(join(domain, shared_memory, None, clouds=True), Kind.CLOUD, sensor, timeout)
