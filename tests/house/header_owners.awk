# "HEADER PACKAGE" for every installed package that has one of the headers, as #include names them.
# Input: the headers, one a line; then dpkg's lists of files, /var/lib/dpkg/info/*.list.
FNR == NR { wanted[$1]; next }
FNR == 1 { package = FILENAME; sub(/.*\//, "", package); sub(/(:[a-z0-9]+)?\.list$/, "", package) }
/\/include\// {
  for (path = $0; (slash = index(path, "/")) > 0;) {
    path = substr(path, slash + 1)
    if (path in wanted) print path, package
  }
}
