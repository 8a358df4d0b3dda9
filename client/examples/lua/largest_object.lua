-- SPDX-License-Identifier: BSD-3-Clause
-- In Lua (LuaJIT): prints the largest object of every frame, as 01_print_segments.cpp does, and the
-- point of it that is nearest to the camera, read where the camera's grabber wrote it.
--
--     apt-get install luajit
--     LD_LIBRARY_PATH=build/release/lib luajit client/examples/lua/largest_object.lua [SENSOR [FRAMES]]
local ffi = require("ffi")

-- Declares what cleave.h declares, read from it: LuaJIT knows C, but no preprocessor.
local function load_cleave(path)
  local header = assert(io.open(path)):read("*a")
  local version = tonumber(header:match("#define CLEAVE_ABI_VERSION (%d+)"))
  header = header:gsub("#ifdef __cplusplus.-#endif", ""):gsub("#[^\n]*", ""):gsub("CLEAVE_API", "")
  ffi.cdef(header)
  local library = ffi.load("cleave-c")
  local found = library.cleave_abi_version()
  if found ~= version then
    error(("libcleave-c has ABI version %d, %s is of %d"):format(found, path, version), 0)
  end
  return library
end

local here = arg[0]:match("^(.*/)") or "./"
local cleave = load_cleave(here .. "../../c/cleave.h")

local function check(result)
  if result ~= cleave.CLEAVE_OK then error(ffi.string(cleave.cleave_error()), 0) end
end

-- A place for a pointer that the library writes: place[0].
local function place(type) return ffi.new(type .. "*[1]") end

local function open_frames(sensor)
  local stream, frames = place("cleave_stream"), place("cleave_frames")
  check(cleave.cleave_open(nil, stream))
  stream = ffi.gc(stream[0], cleave.cleave_close)  -- it lives on for its frames
  check(cleave.cleave_frames_open(stream, sensor, frames))
  return ffi.gc(frames[0], cleave.cleave_frames_close)
end

-- The next frame's cloud, labels and segments; or nil and why there is none.
local function next_frame(frames, timeout_ms)
  local cloud, labels = place("cleave_sample"), place("cleave_sample")
  local segments = place("cleave_sample")
  local result = cleave.cleave_frames_next(frames, timeout_ms, cloud, labels, segments)
  if result == cleave.CLEAVE_FAILED then check(result) end
  if result ~= cleave.CLEAVE_OK then return nil, ffi.string(cleave.cleave_error()) end
  local function owned(sample) return ffi.gc(sample[0], cleave.cleave_release) end
  return {cloud = owned(cloud), labels = owned(labels), segments = owned(segments)}
end

-- Gives a frame's memory back to the camera's grabber at once. The collector would, too, but in no
-- hurry, for a pointer is small. What pointed into that memory must not be used any more.
local function release(frame)
  for _, sample in pairs(frame) do cleave.cleave_release(ffi.gc(sample, nil)) end
end

local function nearest(frame, label)
  local xyz, labels = place("const float"), place("const uint16_t")
  local count = ffi.new("size_t[1]")
  check(cleave.cleave_sample_cloud(frame.cloud, xyz, count))
  check(cleave.cleave_sample_labels(frame.labels, labels, count, nil))
  local least = math.huge
  for i = 0, tonumber(count[0]) - 1 do
    if labels[0][i] == label then least = math.min(least, xyz[0][3 * i + 2]) end
  end
  return least
end

local function print_object(frame)
  local list = ffi.new("cleave_list")
  check(cleave.cleave_sample_list(frame.segments, list))
  if list.segment_count < 2 then return end
  -- Labels go by size: the first is most often the table, the second the largest object.
  local object = list.segments[1]
  local id, centroid = tonumber(list.header.frame_id), object.centroid
  print(("frame %d: %d segments; the second has %d points around (%.2f, %.2f, %.2f) m"):format(
    id, tonumber(list.segment_count), object.point_count, centroid.x, centroid.y, centroid.z))
  local how = cleave.cleave_sample_zero_copy(frame.cloud) ~= 0 and "zero copy" or "copied"
  io.stderr:write(("frame %d: nearest point at %.3f m (%s)\n"):format(
    id, nearest(frame, object.label), how))
end

local function main(sensor, frame_count)
  local left = tonumber(frame_count or math.huge)
  if not left then error("FRAMES is a number, not '" .. frame_count .. "'", 0) end
  local frames = open_frames(sensor or "camera")
  while left > 0 do
    local frame, why = next_frame(frames, 5000)
    if frame then
      print_object(frame)
      release(frame)
      left = left - 1
    else
      io.stderr:write(why, "\n")  -- nobody there (any more): somebody may come
    end
  end
end

io.stdout:setvbuf("line")
local ok, problem = pcall(main, arg[1], arg[2])
if not ok then
  io.stderr:write(problem, "\n")
  os.exit(1)
end
