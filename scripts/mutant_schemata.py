"""Puts many changes of one token into a source, of which the environment variable MUTANT chooses one at run time: the
source is compiled and linked once for all of them (mutant schemata).

An operator is changed by a tag between its operands, `a + Between<1, Plus, Minus>() + b`, so that what belongs to the
operands is for the compiler to tell. What this cannot express does not compile, or is None here: it is tried by itself.
"""

import re

HEADER = r"""
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>

namespace mutants {

static const int chosen = [] {
  const char* const text = std::getenv("MUTANT");
  return text ? std::atoi(text) : 0;
}();

template <class T>
struct PlainOf {
  using Type = T;
};
template <class T>
  requires requires { typename T::PlainObject; }
struct PlainOf<T> {
  using Type = typename T::PlainObject;
};
template <class T>
using Plain = typename PlainOf<std::remove_cvref_t<T>>::Type;

template <int k, class Was, class Becomes>
struct Between {};
template <int k, class Was, class Becomes, class A>
struct Waiting {
  const A& a;
  template <class B>
  auto with(const B& b) const {
    using Result = Plain<decltype(Was::of(a, b))>;
    if (chosen == k) return Result(Becomes::of(a, b));
    return Result(Was::of(a, b));
  }
};

#define MUTANTS_OPERATOR(Name, sign)                                                \
  struct Name {                                                                     \
    template <class A, class B>                                                     \
    static auto of(const A& a, const B& b) {                                        \
      return Plain<decltype(a sign b)>(a sign b);                                   \
    }                                                                               \
  };                                                                                \
  template <class A, int k, class Was, class Becomes>                               \
  Waiting<k, Was, Becomes, A> operator sign(const A& a, Between<k, Was, Becomes>) { \
    return {a};                                                                     \
  }                                                                                 \
  template <class A, int k, class Was, class Becomes, class B>                      \
  auto operator sign(const Waiting<k, Was, Becomes, A>& waiting, const B& b) {      \
    return waiting.with(b);                                                         \
  }
MUTANTS_OPERATOR(Plus, +)
MUTANTS_OPERATOR(Minus, -)
MUTANTS_OPERATOR(Times, *)
MUTANTS_OPERATOR(Over, /)
MUTANTS_OPERATOR(Equal, ==)
MUTANTS_OPERATOR(Unequal, !=)
MUTANTS_OPERATOR(Less, <)
MUTANTS_OPERATOR(LessEqual, <=)
MUTANTS_OPERATOR(Greater, >)
MUTANTS_OPERATOR(GreaterEqual, >=)

/// Of += and -=, and of a sign in front.
template <int k>
struct Sign {
  template <class B>
  Plain<B> operator=(const B& b) const {
    if (chosen == k) return -b;
    return b;
  }
  template <class B>
  friend auto operator-(Sign, const B& b) {
    using Result = Plain<decltype(-b)>;
    if (chosen == k) return Result(b);
    return Result(-b);
  }
};

template <int k, bool is_min>
struct Extreme {
  template <class A>
  A operator()(const A& a, const A& b) const {
    return (chosen == k) != is_min ? std::min(a, b) : std::max(a, b);
  }
  template <class A>
  A operator()(std::initializer_list<A> all) const {
    return (chosen == k) != is_min ? std::min(all) : std::max(all);
  }
};

template <int k, bool is_sine>
struct Circular {
  template <class A>
  auto operator()(const A& a) const {
    return (chosen == k) != is_sine ? std::sin(a) : std::cos(a);
  }
};

}  // namespace mutants
"""

OPERATORS = {
    "+": "Plus", "-": "Minus", "*": "Times", "/": "Over", "==": "Equal", "!=": "Unequal",
    "<": "Less", "<=": "LessEqual", ">": "Greater", ">=": "GreaterEqual",
}  # fmt: skip
OPENING, CLOSING = "([{", ")]}"


def operand_begin(code, end, stops):
    """Where the operand begins that ends at `end`: behind a stop or an open bracket; None if before this line."""
    depth = 0
    for i in range(end - 1, -1, -1):
        if code[i] in CLOSING:
            depth += 1
        elif code[i] in OPENING:
            depth -= 1
            if depth < 0:
                return i + 1
        if depth == 0 and any(code.startswith(stop, i) for stop in stops):
            return i + next(len(stop) for stop in stops if code.startswith(stop, i))
    return None


def operand_end(code, begin, stops):
    """Where the operand ends that begins at `begin`, likewise."""
    depth = 0
    for i in range(begin, len(code)):
        if code[i] in OPENING:
            depth += 1
        elif code[i] in CLOSING:
            depth -= 1
            if depth < 0:
                return i
        if depth == 0 and any(code.startswith(stop, i) for stop in stops):
            return i
    return None


def either(code, place, old, chosen):
    """`L && R` as L || R where it is chosen, and the other way round."""
    ends = [" = ", "return ", " ? ", " : ", ", ", ";"]
    begin = operand_begin(code, place, ends + ([" || "] if old == "&&" else []))
    end = operand_end(code, place + len(old) + 2, ends + [" && ", " || "])
    if begin is None or end is None:
        return None
    left, right = code[begin:place], code[place + len(old) + 2 : end]
    other = "||" if old == "&&" else "&&"
    return f"{code[:begin]}({chosen} ? ({left} {other} {right}) : ({left} {old} {right})){code[end:]}"


def switched(line, place, old, new, k):
    """The line with the change from old to new at a place that is made where k is chosen."""
    chosen = f"(mutants::chosen == {k})"
    before, after = line[:place], line[place + len(old) :]
    old, new = old.strip(), new.strip()
    if not new and not old.startswith(("(", "return")):
        return re.sub(r"^(\s*)(.*;)", rf"\1{{ if (!{chosen}) \2 }}", line)
    if old in OPERATORS:
        return f"{before} {old} mutants::Between<{k}, mutants::{OPERATORS[old]}, mutants::{OPERATORS[new]}>() {old} {after}"
    if old in ("+=", "-="):
        return f"{before} {old} mutants::Sign<{k}>() = {after}"
    if old in ("&&", "||"):
        return either(line, place, old, chosen)
    if old in ("(-", "return -"):
        return f"{before}{old[:-1]}mutants::Sign<{k}>() - {after}"
    if old == "(!":
        return f"{before}({chosen} != !{after}"
    if old in ("std::min", "std::max"):
        return f"{before}mutants::Extreme<{k}, {str(old == 'std::min').lower()}>(){after}"
    if old in ("std::sin", "std::cos"):
        return f"{before}mutants::Circular<{k}, {str(old == 'std::sin').lower()}>(){after}"
    return f"{before}({chosen} ? {new} : {old}){after}"
