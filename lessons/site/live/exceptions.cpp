// What Debian's libc++abi for wasm32-wasi leaves out: throwing and catching, on WebAssembly's own exceptions.
// (The Itanium ABI's functions, for one thread, without dependent or foreign exceptions.)
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

namespace __cxxabiv1 {
class __shim_type_info : public std::type_info {  // as libc++abi lays it out (private_typeinfo.h)
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& adjusted) const = 0;
};
}  // namespace __cxxabiv1

namespace {
using Type = __cxxabiv1::__shim_type_info;

struct alignas(16) Thrown {  // stands before the object
  const Type* type;
  void* (*destroy)(void*);  // on WebAssembly destructors return their object
  void* adjusted;
  Thrown* below;  // on the stack of what is being handled
  int handlers;   // negative: rethrown
  int references;
  void* object() { return this + 1; }
};
Thrown* of(void* object) { return static_cast<Thrown*>(object) - 1; }
Thrown* handled = nullptr;
int in_flight = 0;

void release(Thrown* t) {
  if (--t->references > 0) return;
  if (t->destroy) t->destroy(t->object());
  std::free(t);
}
[[noreturn]] void raise(Thrown* t) {
  ++in_flight;
  __builtin_wasm_throw(0, t);
}

std::uintptr_t uleb(const std::uint8_t*& p) {
  std::uintptr_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *p++;
    value |= std::uintptr_t(byte & 0x7f) << shift;
    if (!(byte & 0x80)) return value;
  }
}
std::intptr_t sleb(const std::uint8_t*& p) {
  std::uintptr_t value = 0;
  unsigned shift = 0;
  std::uint8_t byte;
  do {
    byte = *p++;
    value |= std::uintptr_t(byte & 0x7f) << shift;
    shift += 7;
  } while (byte & 0x80);
  if ((byte & 0x40) && shift < 32) value |= ~std::uintptr_t(0) << shift;
  return std::intptr_t(value);
}
}  // namespace

extern "C" {
struct LandingPad {
  std::uintptr_t index, lsda, selector;
};
LandingPad __wasm_lpad_context;

/// Which handler of this frame takes the exception: its number, or 0 for clean-ups alone.
int _Unwind_CallPersonality(void* exception) {
  Thrown* t = static_cast<Thrown*>(exception);
  __wasm_lpad_context.selector = 0;
  const std::uint8_t* p = reinterpret_cast<const std::uint8_t*>(__wasm_lpad_context.lsda);
  if (!p) return 0;
  if (*p++ != 0xff) uleb(p);  // where landing pads begin: absent
  const std::uint8_t types_encoding = *p++;
  const std::uint8_t* types = nullptr;
  if (types_encoding != 0xff) {
    const std::uintptr_t offset = uleb(p);
    types = p + offset;
  }
  ++p;  // encoding of the table: uleb128
  const std::uintptr_t size = uleb(p);
  const std::uint8_t* actions = p + size;
  std::uintptr_t pad, action;
  std::uintptr_t left = __wasm_lpad_context.index + 1;
  do {
    pad = uleb(p), action = uleb(p);
  } while (--left > 0);
  (void)pad;
  if (action == 0) return 0;
  for (const std::uint8_t* a = actions + (action - 1);;) {
    const std::intptr_t type = sleb(a);
    if (type > 0) {
      const Type* catches = reinterpret_cast<const Type* const*>(types)[-type];
      void* adjusted = t->object();
      if (!catches || catches->can_catch(t->type, adjusted)) {
        t->adjusted = adjusted;
        __wasm_lpad_context.selector = std::uintptr_t(type);
        return 0;
      }
    }
    const std::uint8_t* at = a;
    const std::intptr_t next = sleb(a);
    if (next == 0) return 0;
    a = at + next;
  }
}

void* __cxa_allocate_exception(std::size_t size) throw() {
  Thrown* t = static_cast<Thrown*>(std::calloc(1, sizeof(Thrown) + size));
  if (!t) std::abort();
  return t->object();
}
void __cxa_free_exception(void* object) throw() { std::free(of(object)); }
[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown* t = of(object);
  t->type = static_cast<const Type*>(static_cast<const std::type_info*>(type));
  t->destroy = destroy;
  t->adjusted = object;
  t->references = 1;
  raise(t);
}
void* __cxa_begin_catch(void* exception) throw() {
  Thrown* t = static_cast<Thrown*>(exception);
  t->handlers = t->handlers < 0 ? 1 - t->handlers : t->handlers + 1;
  if (handled != t) t->below = handled, handled = t;
  --in_flight;
  return t->adjusted;
}
void __cxa_end_catch() {
  Thrown* t = handled;
  if (!t) return;
  if (t->handlers < 0) {
    if (++t->handlers == 0) handled = t->below;
  } else if (--t->handlers == 0) {
    handled = t->below;
    release(t);
  }
}
[[noreturn]] void __cxa_rethrow() {
  Thrown* t = handled;
  if (!t) std::terminate();
  t->handlers = -t->handlers;
  raise(t);
}
void* __cxa_get_exception_ptr(void* exception) throw() { return static_cast<Thrown*>(exception)->adjusted; }
std::type_info* __cxa_current_exception_type() {
  return handled ? const_cast<std::type_info*>(static_cast<const std::type_info*>(handled->type)) : nullptr;
}
void* __cxa_current_primary_exception() throw() {
  if (!handled) return nullptr;
  ++handled->references;
  return handled->object();
}
void __cxa_increment_exception_refcount(void* object) throw() {
  if (object) ++of(object)->references;
}
void __cxa_decrement_exception_refcount(void* object) throw() {
  if (object) release(of(object));
}
void __cxa_rethrow_primary_exception(void* object) {
  if (!object) return;
  Thrown* t = of(object);
  ++t->references;
  t->adjusted = object;
  t->handlers = 0;  // (sound while the same exception is not being handled)
  raise(t);
}
bool __cxa_uncaught_exception() throw() { return in_flight > 0; }
unsigned int __cxa_uncaught_exceptions() throw() { return unsigned(in_flight); }
}
