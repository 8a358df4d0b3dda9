# SPDX-License-Identifier: BSD-3-Clause
"""Between samples and bytes of CDR, as recordings and other clients have them. Needs no stream."""

from __future__ import annotations

import ctypes
from typing import Literal, overload

from ._handles import opened
from ._library import check, lib
from .samples import Cloud, LabelMap, Sample, SegmentList, Status, status_of
from .types import Kind


@overload
def decode(kind: Literal[Kind.CLOUD], data: bytes, *, large: bool = ...) -> Cloud: ...
@overload
def decode(kind: Literal[Kind.LABELS], data: bytes, *, large: bool = ...) -> LabelMap: ...
@overload
def decode(kind: Literal[Kind.SEGMENTS], data: bytes, *, large: bool = ...) -> SegmentList: ...
@overload
def decode(kind: Literal[Kind.STATUS], data: bytes, *, large: bool = ...) -> Status: ...
def decode(kind: Kind, data: bytes, *, large: bool = False) -> Sample | Status:
    """The sample that `data` is: CDR of either byte order, with its 4 bytes of encapsulation.

    `large`: of the contract's LargeDepthCloud or LargeLabelMap. BadData if it is cut off, of
    another kind, or lies about a length.
    """
    data = bytes(data)
    pointer = opened(lib.cleave_decode, int(kind), int(large), data, len(data))
    if kind == Kind.CLOUD:
        return Cloud(pointer)
    if kind == Kind.LABELS:
        return LabelMap(pointer)
    if kind == Kind.SEGMENTS:
        return SegmentList(pointer)
    return status_of(Sample(pointer))


def encode(sample: Sample | Status) -> bytes:
    """CDR, little endian, with its encapsulation."""
    handle = sample.sample if isinstance(sample, Status) else sample
    first, size = ctypes.c_void_p(), ctypes.c_size_t()
    check(lib.cleave_encode(handle.pointer, ctypes.byref(first), ctypes.byref(size)))
    return ctypes.string_at(first, size.value)
