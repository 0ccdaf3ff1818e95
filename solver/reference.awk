# Reads a header as Doxygen should: what stands above its namespace is about the file, indented lines are as they are
# written, and a comment behind a member is the member's.
/^ *\/\/! \[/ { print ""; next }  # the marks of what lessons show
/^namespace/ { inside = 1 }
ended { print ""; next }  # what another library asks for
/^}  \/\/ namespace byhand/ { ended = 1 }
!inside && /^\/\/( |$)/ {
  if (!begun++) printf "/// @file\n///\n"
  sub(/^\/\/   /, "//      ")
  sub(/^\/\//, "///")
}
inside && /[;,{}]  ?\/\/ / { sub(/\/\/ /, "///< ") }
{ print }
