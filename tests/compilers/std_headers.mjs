// Which standard header brings which names of std. A name that several headers bring stands with each of them, and so does a base
// class with those that derive from it.
const rows = `
algorithm: adjacent_find all_of any_of clamp copy count count_if equal erase_if fill fill_n find find_if find_if_not generate lower_bound max max_element min min_element minmax minmax_element mismatch none_of nth_element reverse sort upper_bound ranges::adjacent_find ranges::all_of ranges::any_of ranges::count ranges::count_if ranges::equal ranges::fill ranges::find ranges::find_if ranges::find_if_not ranges::max ranges::max_element ranges::min ranges::min_element ranges::minmax ranges::mismatch ranges::none_of ranges::replace ranges::reverse ranges::sort ranges::transform
array: array tuple_size_v get size begin end
bit: bit_cast
cctype: isalnum isalpha isdigit isspace tolower toupper
cerrno:
cfenv: fesetenv fegetenv feclearexcept
charconv: from_chars to_chars chars_format
chrono: chrono chrono_literals
cmath: abs acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf exp exp2 expm1 fabs floor fma fmod fpclassify frexp hypot ilogb isfinite isinf isnan ldexp lerp llround log log10 log1p log2 lround modf nan nextafter pow remainder round signbit sin sinh sqrt tan tanh trunc
compare: strong_ordering
complex: complex abs arg polar conj norm real imag exp sqrt
concepts: constructible_from convertible_to floating_point same_as
cstddef: byte nullptr_t ptrdiff_t size_t to_integer
cstdint: int32_t int64_t uint8_t uint16_t uint32_t uint64_t uintmax_t uintptr_t
cstdio: FILE fclose ferror fflush fgetc fopen fprintf fputs fread fwrite perror printf putchar puts remove rewind setvbuf snprintf sscanf tmpfile size_t
cstdlib: abort abs atoi exit free getenv malloc strtod strtol strtoul system size_t
cstring: memcmp memcpy memset strcmp strerror strlen size_t
ctime: gmtime tm size_t strftime time time_t
deque: deque erase_if size begin end
exception: exception current_exception exception_ptr terminate
expected: expected
experimental/simd: experimental::native_simd experimental::fixed_size_simd experimental::vector_aligned experimental::element_aligned
filesystem: filesystem
fstream: fstream ifstream ofstream getline ios streamsize
functional: bind_front function hash invoke multiplies not_fn plus reference_wrapper ref cref ranges::greater
initializer_list: initializer_list begin end
iomanip: setprecision setw
ios: ios hex fixed streamsize
iostream: cerr cin clog cout endl flush ios ostream istream streamsize
istream: istream getline ios streamsize
iterator: back_inserter begin distance end istreambuf_iterator istream_iterator next prev size
limits: numeric_limits
map: map multimap erase_if size begin end
memory: make_shared make_unique shared_ptr unique_ptr weak_ptr
mutex: lock_guard mutex scoped_lock
new: bad_alloc
numbers: numbers
numeric: accumulate gcd inner_product iota lcm midpoint partial_sum reduce
optional: make_optional nullopt nullopt_t optional hash
ostream: ostream flush endl ios streamsize
random: mt19937 mt19937_64 normal_distribution random_device seed_seq uniform_int_distribution uniform_real_distribution
regex: regex regex_match regex_replace regex_search smatch sregex_iterator
set: set multiset erase_if size begin end
source_location: source_location
span: as_bytes as_writable_bytes span size begin end
sstream: istringstream ostringstream stringstream getline ios streamsize
stdexcept: exception invalid_argument logic_error out_of_range runtime_error domain_error length_error
string: char_traits erase erase_if getline stod stof stoi stol stoll stoul stoull string string_literals to_string size begin end hash swap
string_view: string_view string_view_literals size begin end hash
system_error: exception errc error_code generic_category system_category system_error
thread: jthread this_thread thread
tuple: apply get ignore make_tuple tie tuple tuple_cat tuple_element_t tuple_size tuple_size_v
type_traits: common_type_t conditional_t decay_t enable_if_t false_type integral_constant invoke_result_t is_arithmetic_v is_base_of_v is_constant_evaluated is_const_v is_convertible_v is_default_constructible_v is_floating_point_v is_empty_v is_integral_v is_invocable is_invocable_r_v is_invocable_v is_same_v is_standard_layout_v is_trivially_copyable_v is_void_v remove_const_t remove_cv_t remove_cvref_t remove_reference_t true_type type_identity_t void_t
typeinfo: type_info
unordered_map: unordered_map
utility: declval exchange forward get index_sequence index_sequence_for integer_sequence make_index_sequence make_pair move pair swap as_const tuple_size tuple_size_v tuple_element_t
valarray: valarray
variant: get get_if holds_alternative monostate variant visit
vector: erase erase_if size begin end vector
`;

// name: the headers that bring it
export const headersOf = new Map();
for (const row of rows.trim().split('\n')) {
  const [header, names] = row.split(':', 1).concat(row.slice(row.indexOf(':') + 1));
  for (const name of names.trim().split(/\s+/).filter(Boolean))
    headersOf.set(name, [...(headersOf.get(name) ?? []), header]);
}
for (const ratio of ['nano', 'micro', 'milli']) headersOf.set(ratio, ['ratio', 'chrono']);
headersOf.set('literals', ['string', 'string_view', 'chrono']);
