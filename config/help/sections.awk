# A program's --help as CLI11 writes it, cut up for what is made of it, one line each:
#   what TAB name TAB text
# where what is description, usage, option, command, or footer, the text of which is a line as it
# stands. An option's name is all that stands before its text: "-h,--help", "--unit TEXT:{m,cm,mm}".
# Texts begin in column 31, in a line of their own where the name is too long for that.
function flush() {
  if (line != "" && text == "") { text = substr(line, 31); line = substr(line, 1, 30) }
  gsub(/^ +| +$/, "", line)
  if (line != "") print kind "\t" line "\t" text
  line = text = ""
}
NR == 1 { print "description\t\t" $0; next }
/^Usage: / { print "usage\t\t" substr($0, 8); next }
kind == "footer" { print "footer\t\t" $0; next }
/^(Options|Positionals):$/ { flush(); kind = "option"; next }
/^Subcommands:$/ { flush(); kind = "command"; next }
match($0, /^ +/) && RLENGTH == 30 { text = substr($0, 31); next }
/^  [^ ]/ { flush(); line = $0; next }
/^$/ { flush(); next }
kind != "" { kind = "footer"; print "footer\t\t" $0 }
END { flush() }
