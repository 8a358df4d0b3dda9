# A manual page from what sections.awk made of a program's --help.
# Variables: name, of the page; version, of the program.
function plain(line) {  # what troff would take for its own
  gsub(/\\/, "\\e", line); gsub(/-/, "\\-", line); gsub(/`/, "\\(ga", line)
  if (line ~ /^[.']/) line = "\\\\&" line
  return line
}
function section(title) {
  end_verbatim()
  print ".SH " toupper(title)
}
function end_verbatim() { if (verbatim) print ".EE"; verbatim = 0 }
$1 == "description" {
  sub(/\.$/, "", $3)
  print ".TH \"" toupper(name) "\" 1 \"\" \"Cleave " version "\" \"Cleave\""
  section("name"); print plain(name) " \\- " plain($3)
}
$1 == "usage" { section("synopsis"); print plain($3) }
$1 == "option" || $1 == "command" {
  if ($1 != before) section($1 "s")
  print ".TP\n.B " plain($2) "\n" plain($3)
}
$1 == "footer" && $3 ~ /^[A-Z][a-z]+:$/ {  # "Examples:"
  section(substr($3, 1, length($3) - 1)); print ".EX"; verbatim = 1
  next
}
$1 == "footer" {
  if (!verbatim && before != "footer") section("notes")
  if (!verbatim) print ".EX"
  verbatim = 1
  print plain($3)
}
{ before = $1 }
END { end_verbatim() }
