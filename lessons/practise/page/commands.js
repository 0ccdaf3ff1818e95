'use strict';
// What clang's driver would tell clang and lld, which it cannot start here.

// REMOVE_TRANSITIVE_INCLUDES: <span> draws in a tenth.
const headers = '/usr/include';
const common = `-triple wasm32-unknown-wasip1 -emit-obj -O1 -std=c++20 -x c++ -disable-free -clear-ast-before-backend
  -mrelocation-model static -mframe-pointer=none -ffp-contract=off -fno-rounding-math -mconstructor-aliases -target-cpu generic
  -fvisibility=hidden -resource-dir /usr -isysroot /usr -internal-isystem ${headers}/wasm32-wasip1/c++/v1
  -internal-isystem ${headers}/c++/v1 -internal-isystem ${headers} -internal-isystem ${headers}/wasm32-wasip1
  -fdeprecated-macro -fgnuc-version=4.2.1 -fskip-odr-check-in-gmf -Wall -Wno-unknown-pragmas -Werror=return-type -iquote /
  -D_LIBCPP_REMOVE_TRANSITIVE_INCLUDES`;

// As the terminal's judge compiles (check.cpp), and besides:
//   finite-loops    without it a loop that never ends is taken away
//   coverage        each branch is counted, so that such a loop is stopped where it is
//   debug-info      from the place where code stopped to its line
//   HARDENING       the library's own checks of indices name what was out of bounds
const learners = `-ferror-limit 3 -fno-finite-loops -fsanitize-coverage-type=3 -fsanitize-coverage-trace-pc
  -fsanitize-coverage-no-prune
  -debug-info-kind=line-tables-only -dwarf-version=4
  -fsanitize=integer-divide-by-zero,signed-integer-overflow,array-bounds,float-cast-overflow,null,unreachable
  -fmacro-prefix-map=/learner/= -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_FAST
  -D_LIBCPP_ENABLE_EXPERIMENTAL -D_LIBCPP_ASSERTION_SEMANTIC=_LIBCPP_ASSERTION_SEMANTIC_ENFORCE`;

const words = text => text.split(/\s+/);

// An excerpt of a lesson stands in its namespace, and its lines are numbered as they are shown.
const spaces = { step: 'byhand::single_constraint', sweep: 'byhand::iterations', bias: 'byhand::baumgarte', clamp: 'byhand::contact' };
const placed = (name, text) => spaces[name] ? `namespace ${spaces[name]} {\n#line 1\n${text}\n}\n` : text;

// The learner's `file` of exercise `name`.
function compileCommand(name, file, object) {
  return ['clang++', '-cc1', ...words(common), ...words(learners), '-include', `/${name}/signature.hpp`, '-o', object, file];
}

// What is linked with it (learner_page.cpp).
function wrapperCommand(name, source, object) {
  return ['clang++', '-cc1', ...words(common), `-DBYHAND_SIGNATURE="${name}/signature.hpp"`, '-o', object, source];
}

function linkCommand(name, object, program) {
  const library = '/usr/lib/wasm32-wasip1', runtime = '/usr/lib/wasm32-unknown-wasip1';
  return ['wasm-ld', ...words(`-m wasm32 -L${runtime} -L${library} ${library}/crt1-reactor.o --entry _initialize
    /${name}/wrapper.o ${object} -lc++ -lc++abi -lc ${runtime}/libclang_rt.builtins.a --stack-first -z stack-size=1048576
    --max-memory=268435456 -o ${program}`)];
}
