// SPDX-License-Identifier: BSD-3-Clause

// In Go: prints the largest object of every frame, as 01_print_segments.cpp does, and the point of
// it that is nearest to the camera, read where the camera's grabber wrote it.
//
//	apt-get install golang-go
//	CGO_CFLAGS=-I$PWD/client/c CGO_LDFLAGS=-L$PWD/build/release/lib go build -o build/release/object_go client/examples/go/largest_object.go
//	LD_LIBRARY_PATH=build/release/lib build/release/object_go [SENSOR [FRAMES]]
package main

// #cgo LDFLAGS: -lcleave-c
// #include <stdlib.h>
// #include "cleave.h"
import "C"

import (
	"errors"
	"fmt"
	"math"
	"os"
	"runtime"
	"strconv"
	"unsafe"
)

// Failure is a result that is not CLEAVE_OK, and the library's words for it.
type Failure struct {
	result C.cleave_result
	text   string
}

func (f *Failure) Error() string { return f.text }

// The words are of the thread that failed: whoever calls this has locked its goroutine to one.
func check(result C.cleave_result) error {
	if result == C.CLEAVE_OK {
		return nil
	}
	return &Failure{result, C.GoString(C.cleave_error())}
}

// Frames of one sensor. For one goroutine at a time.
type Frames struct{ handle *C.cleave_frames }

func openFrames(sensor string) (*Frames, error) {
	name := C.CString(sensor)
	defer C.free(unsafe.Pointer(name))
	var stream *C.cleave_stream
	if err := check(C.cleave_open(nil, &stream)); err != nil {
		return nil, err
	}
	defer C.cleave_close(stream) // it lives on for its frames
	frames := &Frames{}
	return frames, check(C.cleave_frames_open(stream, name, &frames.handle))
}

func (f *Frames) close() { C.cleave_frames_close(f.handle) }

func (f *Frames) next(timeoutMs int32) (*Frame, error) {
	var frame Frame
	err := check(C.cleave_frames_next(f.handle, C.int32_t(timeoutMs),
		&frame.cloud, &frame.labels, &frame.segments))
	return &frame, err
}

// Frame is a cloud, its label map and its segments. Slices of them are of memory that Go does not
// manage: good until release, after which it is the camera's grabber's again. Hold few.
type Frame struct{ cloud, labels, segments *C.cleave_sample }

func (f *Frame) release() {
	for _, sample := range []*C.cleave_sample{f.cloud, f.labels, f.segments} {
		C.cleave_release(sample)
	}
}

func (f *Frame) points() ([][3]float32, error) {
	var xyz *C.float
	var count C.size_t
	err := check(C.cleave_sample_cloud(f.cloud, &xyz, &count))
	return unsafe.Slice((*[3]float32)(unsafe.Pointer(xyz)), int(count)), err
}

func (f *Frame) labelMap() ([]C.uint16_t, error) {
	var labels *C.uint16_t
	var count C.size_t
	err := check(C.cleave_sample_labels(f.labels, &labels, &count, nil))
	return unsafe.Slice(labels, int(count)), err
}

func (f *Frame) list() (C.cleave_list, error) {
	var list C.cleave_list
	err := check(C.cleave_sample_list(f.segments, &list))
	return list, err
}

func print(frame *Frame) error {
	defer frame.release()
	list, err := frame.list()
	if err != nil || list.segment_count < 2 {
		return err
	}
	points, err := frame.points()
	if err != nil {
		return err
	}
	labels, err := frame.labelMap()
	if err != nil {
		return err
	}
	// Labels go by size: the first is most often the table, the second the largest object.
	object := unsafe.Slice(list.segments, int(list.segment_count))[1]
	id, centroid := list.header.frame_id, object.centroid
	fmt.Printf("frame %d: %d segments; the second has %d points around (%.2f, %.2f, %.2f) m\n",
		id, list.segment_count, object.point_count, centroid.x, centroid.y, centroid.z)
	nearest := float32(math.Inf(1))
	for i, label := range labels {
		if label == object.label && points[i][2] < nearest {
			nearest = points[i][2]
		}
	}
	how := "copied"
	if C.cleave_sample_zero_copy(frame.cloud) != 0 {
		how = "zero copy"
	}
	fmt.Fprintf(os.Stderr, "frame %d: nearest point at %.3f m (%s)\n", id, nearest, how)
	return nil
}

func run(sensor string, left uint64) error {
	frames, err := openFrames(sensor)
	if err != nil {
		return err
	}
	defer frames.close()
	for left > 0 {
		frame, err := frames.next(5000)
		var failure *Failure
		if errors.As(err, &failure) && failure.result != C.CLEAVE_FAILED {
			fmt.Fprintln(os.Stderr, err) // nobody there (any more): somebody may come
			continue
		}
		if err == nil {
			err = print(frame)
		}
		if err != nil {
			return err
		}
		left--
	}
	return nil
}

func main() {
	runtime.LockOSThread() // see check
	sensor, left := "camera", uint64(math.MaxUint64)
	var err error
	if len(os.Args) > 1 {
		sensor = os.Args[1]
	}
	if len(os.Args) > 2 {
		if left, err = strconv.ParseUint(os.Args[2], 10, 64); err != nil {
			err = fmt.Errorf("FRAMES is a number, not '%s'", os.Args[2])
		}
	}
	if err == nil {
		err = run(sensor, left)
	}
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}
