// SPDX-License-Identifier: BSD-3-Clause
//! In Rust, with its standard library alone: prints the largest object of every frame, as
//! 01_print_segments.cpp does, and the point of it that is nearest to the camera, read where the
//! camera's grabber wrote it.
//!
//!     apt-get install rustc
//!     rustc --edition 2021 -O -L build/release/lib -o build/release/object_rs client/examples/rust/largest_object.rs
//!     LD_LIBRARY_PATH=build/release/lib build/release/object_rs [SENSOR [FRAMES]]
use std::error::Error;
use std::ffi::{CStr, CString};
use std::process::ExitCode;
use std::{ptr, slice};

/// Of cleave.h what is needed here. The linker notes the library's name with its ABI version, so
/// that another one is refused when the program starts.
#[rustfmt::skip]
mod c {
    use std::os::raw::{c_char, c_void};
    pub type Handle = *mut c_void;
    pub const OK: i32 = 0;
    pub const FAILED: i32 = 5;
    /// Read through a pointer only, so what follows may be left out.
    #[repr(C)] pub struct Header { pub frame_id: u64 }
    #[repr(C)] pub struct Point { pub x: f32, pub y: f32, pub z: f32 }
    #[repr(C)] pub struct Box { centre: Point, orientation: [f32; 4], extent: Point }
    #[repr(C)] pub struct Segment {
        pub label: u16, pub point_count: u32, pub centroid: Point, mean_normal: Point,
        oriented_box: Box, rectangle: [u32; 4], planarity: f32,
    }
    #[repr(C)] pub struct List {
        pub header: *const Header, cloud_publication_time_ns: i64, cloud_reception_time_ns: i64,
        outcome: u32, pub segments: *const Segment, pub segment_count: usize,
        borders: *const c_void, border_count: usize, queue_ms: f32, segmentation_ms: f32,
    }
    #[link(name = "cleave-c")]
    extern "C" {
        pub fn cleave_error() -> *const c_char;
        pub fn cleave_open(options: *const c_void, stream: *mut Handle) -> i32;
        pub fn cleave_close(stream: Handle);
        pub fn cleave_frames_open(stream: Handle, sensor: *const c_char,
                                  frames: *mut Handle) -> i32;
        pub fn cleave_frames_close(frames: Handle);
        pub fn cleave_frames_next(frames: Handle, timeout_ms: i32, cloud: *mut Handle,
                                  labels: *mut Handle, segments: *mut Handle) -> i32;
        pub fn cleave_release(sample: Handle);
        pub fn cleave_sample_zero_copy(sample: Handle) -> i32;
        pub fn cleave_sample_cloud(sample: Handle, xyz: *mut *const [f32; 3],
                                   count: *mut usize) -> i32;
        pub fn cleave_sample_labels(sample: Handle, labels: *mut *const u16, count: *mut usize,
                                    cloud_publication_time_ns: *mut i64) -> i32;
        pub fn cleave_sample_list(sample: Handle, list: *mut List) -> i32;
    }
}

/// A result that is not CLEAVE_OK, and the library's words for it.
#[derive(Debug)]
struct Failure(i32, String);

impl std::fmt::Display for Failure {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        formatter.write_str(&self.1)
    }
}
impl Error for Failure {}

fn check(result: i32) -> Result<(), Failure> {
    if result == c::OK {
        return Ok(());
    }
    // Never null; of this thread, and of its last failure.
    let text = unsafe { CStr::from_ptr(c::cleave_error()) };
    Err(Failure(result, text.to_string_lossy().into_owned()))
}

/// Of one sensor. Raw pointers are neither Send nor Sync, so the compiler keeps it in its thread.
struct Frames(c::Handle);

impl Frames {
    fn open(sensor: &str) -> Result<Self, Box<dyn Error>> {
        let name = CString::new(sensor)?;
        let (mut stream, mut frames) = (ptr::null_mut(), ptr::null_mut());
        unsafe {
            check(c::cleave_open(ptr::null(), &mut stream))?;
            let opened = check(c::cleave_frames_open(stream, name.as_ptr(), &mut frames));
            c::cleave_close(stream); // it lives on for its frames
            opened?;
        }
        Ok(Frames(frames))
    }

    fn next(&mut self, timeout_ms: i32) -> Result<Frame, Failure> {
        let mut handles = [ptr::null_mut(); 3];
        let [cloud, labels, segments] = &mut handles;
        check(unsafe { c::cleave_frames_next(self.0, timeout_ms, cloud, labels, segments) })?;
        Ok(Frame(handles))
    }
}

impl Drop for Frames {
    fn drop(&mut self) {
        unsafe { c::cleave_frames_close(self.0) }
    }
}

/// A cloud, its label map and its segments. What it hands out borrows from it, for the memory is
/// the camera's grabber's, and goes back to it when this is dropped: keep few.
struct Frame([c::Handle; 3]);

impl Frame {
    fn cloud(&self) -> Result<&[[f32; 3]], Failure> {
        let (mut xyz, mut count) = (ptr::null(), 0);
        check(unsafe { c::cleave_sample_cloud(self.0[0], &mut xyz, &mut count) })?;
        Ok(unsafe { slice::from_raw_parts(xyz, count) })
    }

    fn labels(&self) -> Result<&[u16], Failure> {
        let (mut labels, mut count, no_time) = (ptr::null(), 0, ptr::null_mut());
        check(unsafe { c::cleave_sample_labels(self.0[1], &mut labels, &mut count, no_time) })?;
        Ok(unsafe { slice::from_raw_parts(labels, count) })
    }

    /// The frame's id, and its segments in the order of their labels 1, 2, ...
    fn segments(&self) -> Result<(u64, &[c::Segment]), Failure> {
        let mut list = std::mem::MaybeUninit::uninit();
        check(unsafe { c::cleave_sample_list(self.0[2], list.as_mut_ptr()) })?;
        let list = unsafe { list.assume_init() };
        let segments = match list.segment_count {
            0 => &[][..],
            count => unsafe { slice::from_raw_parts(list.segments, count) },
        };
        Ok((unsafe { (*list.header).frame_id }, segments))
    }

    fn zero_copy(&self) -> bool {
        unsafe { c::cleave_sample_zero_copy(self.0[0]) != 0 }
    }
}

impl Drop for Frame {
    fn drop(&mut self) {
        for sample in self.0 {
            unsafe { c::cleave_release(sample) }
        }
    }
}

fn print(frame: &Frame) -> Result<(), Failure> {
    let (id, segments) = frame.segments()?;
    // Labels go by size: the first is most often the table, the second the largest object.
    let object = match segments.get(1) {
        Some(object) => object,
        None => return Ok(()),
    };
    let c::Point { x, y, z } = object.centroid;
    println!(
        "frame {id}: {} segments; the second has {} points around ({x:.2}, {y:.2}, {z:.2}) m",
        segments.len(),
        object.point_count
    );
    let points = frame.cloud()?.iter().zip(frame.labels()?);
    let own = points.filter(|(_, label)| **label == object.label);
    let nearest = own.map(|(point, _)| point[2]).fold(f32::INFINITY, f32::min);
    let how = ["copied", "zero copy"][usize::from(frame.zero_copy())];
    eprintln!("frame {id}: nearest point at {nearest:.3} m ({how})");
    Ok(())
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let sensor = arguments.next().unwrap_or_else(|| "camera".into());
    let mut left = match arguments.next() {
        None => u64::MAX,
        Some(text) => match text.parse() {
            Ok(number) => number,
            Err(_) => return Err(format!("FRAMES is a number, not '{text}'").into()),
        },
    };
    let mut frames = Frames::open(&sensor)?;
    while left > 0 {
        match frames.next(5000) {
            Ok(frame) => {
                print(&frame)?;
                left -= 1;
            }
            Err(failure) if failure.0 == c::FAILED => return Err(failure.into()),
            Err(failure) => eprintln!("{failure}"), // nobody there (any more): somebody may come
        }
    }
    Ok(())
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
