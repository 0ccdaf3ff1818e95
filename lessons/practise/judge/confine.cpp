#include "lessons/practise/judge/confine.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace byhand::practise {
namespace {

void set(__rlimit_resource_t resource, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(resource, &limit);
}

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

/// What a static C++ program calls to start, to get memory, to print and to end.
constexpr int allowed[] = {
    SYS_read,           SYS_write,        SYS_writev, SYS_lseek,      SYS_fstat,           SYS_newfstatat,
    SYS_ioctl,          SYS_brk,          SYS_mmap,   SYS_munmap,     SYS_mremap,          SYS_mprotect,
    SYS_madvise,        SYS_getrandom,    SYS_futex,  SYS_readlinkat, SYS_clock_gettime,   SYS_rt_sigaction,
    SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_gettid, SYS_getpid,     SYS_set_tid_address, SYS_exit,
    SYS_exit_group,     SYS_sigaltstack,
    SYS_execve,  // a program that it becomes keeps this filter
#ifdef SYS_arch_prctl
    SYS_arch_prctl,
#endif
#ifdef SYS_readlink
    SYS_readlink,
#endif
#ifdef SYS_rseq
    SYS_rseq,
#endif
    SYS_set_robust_list};

/// Known, harmless if it fails: limits are only read.
constexpr int refused[] = {SYS_prlimit64};

sock_filter load(unsigned offset) { return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offset); }
sock_filter verdict(unsigned action) { return BPF_STMT(BPF_RET | BPF_K, action); }
sock_filter unless(unsigned value) { return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1); }

}  // namespace

std::string missing_confinement() {
  if (syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 1)
    return "This system has no Landlock (Linux 5.13, enabled at boot), so that a submission's #include or .incbin "
           "may "
           "read any file that the judge may read, its keys among them";
  if (architecture == 0 || prctl(PR_GET_SECCOMP, 0, 0, 0, 0) < 0)
    return "This system has no seccomp filter that the judge knows, so that a submission's program may call the "
           "system";
  return "";
}

void limit(const Limits& limits, std::size_t file_bytes) {
  set(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)));
  set(RLIMIT_AS, limits.bytes);
  set(RLIMIT_FSIZE, file_bytes);
  set(RLIMIT_CORE, 0);
  set(RLIMIT_STACK, 8u << 20);
}

void allow_computing_only() {
  constexpr std::size_t most = 4 + 2 * (std::size(allowed) + std::size(refused)) + 4 + 1;
  std::array<sock_filter, most> program{};
  std::size_t size = 0;
  program[size++] = load(offsetof(seccomp_data, arch));
  program[size++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
  program[size++] = verdict(SECCOMP_RET_KILL_PROCESS);
  program[size++] = load(offsetof(seccomp_data, nr));
  for (const int call : allowed) {
    program[size++] = unless(static_cast<unsigned>(call));
    program[size++] = verdict(SECCOMP_RET_ALLOW);
  }
  for (const int call : refused) {
    program[size++] = unless(static_cast<unsigned>(call));
    program[size++] = verdict(SECCOMP_RET_ERRNO | 1);
  }
  // abort() is a signal to itself.
  program[size++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tgkill, 0, 3);
  program[size++] = load(offsetof(seccomp_data, args[0]));
  program[size++] = unless(static_cast<unsigned>(getpid()));
  program[size++] = verdict(SECCOMP_RET_ALLOW);
  program[size++] = verdict(SECCOMP_RET_KILL_PROCESS);
  const sock_fprog filter{static_cast<unsigned short>(size), program.data()};
  if (architecture == 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

void allow_files(const std::vector<std::filesystem::path>& readable, const std::filesystem::path& writable) {
  constexpr __u64 read = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  constexpr __u64 all = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // all of Landlock's first version
  const landlock_ruleset_attr attributes{.handled_access_fs = all};
  const int rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
  if (rules < 0) return;
  const auto allow = [&](const char* path, __u64 access) {
    const int file = open(path, O_PATH | O_CLOEXEC);
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0) return;
    if (!S_ISDIR(status.st_mode))
      access &= LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
    const landlock_path_beneath_attr rule{.allowed_access = access, .parent_fd = file};
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(file);
  };
  for (const char* system : {"/usr", "/bin", "/lib", "/lib64", "/etc/alternatives", "/etc/ld.so.cache"})
    allow(system, read);
  allow("/dev/null", all);
  for (const auto& path : readable) allow(path.c_str(), read);
  allow(writable.c_str(), all);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  syscall(SYS_landlock_restrict_self, rules, 0);
  close(rules);
}

}  // namespace byhand::practise
