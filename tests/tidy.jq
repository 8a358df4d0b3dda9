# Of every dozen of compile_commands.json: its file, its folder, and its command without the compiler
# cache and the output; each ended by a NUL.
.[] | select(.file | endswith(".cxx")) |
  .file, "\u0000", .directory, "\u0000",
  (.command | sub("^.*ccache "; "") | sub(" -o [^ ]+"; "")), "\u0000"
