; What numba's code calls of numba's runtime and of C, for one call of an entry at a time.

; The stack grows down from the end of this, which is at address 0: what overflows it traps.
@stack = global [65536 x i8] zeroinitializer, align 16

; Arrays that live within one call; whatever does not fit traps.
@arena = internal global [1048576 x i8] zeroinitializer, align 32
@used = internal global i32 0

%meminfo = type { i64, ptr, ptr, ptr, i64 }

define void @empty_arena() alwaysinline {
  store i32 0, ptr @used
  ret void
}

define ptr @NRT_MemInfo_alloc_aligned(i64 %size, i32 %align) noinline {
  %is_long = icmp ugt i64 %size, 1048576
  %is_odd = icmp ugt i32 %align, 32
  %is_strange = or i1 %is_long, %is_odd
  br i1 %is_strange, label %full, label %short
short:
  %begin = load i32, ptr @used
  %bytes = trunc i64 %size to i32
  ; 32 for what numba keeps of an array, and the next one is aligned again
  %more = add i32 %bytes, 63
  %taken = and i32 %more, -32
  %end = add i32 %begin, %taken
  %is_full = icmp ugt i32 %end, 1048576
  br i1 %is_full, label %full, label %fits
fits:
  store i32 %end, ptr @used
  %info = getelementptr i8, ptr @arena, i32 %begin
  %data = getelementptr i8, ptr %info, i32 32
  store i64 1, ptr %info
  %data_slot = getelementptr %meminfo, ptr %info, i32 0, i32 3
  store ptr %data, ptr %data_slot
  %size_slot = getelementptr %meminfo, ptr %info, i32 0, i32 4
  store i64 %size, ptr %size_slot
  ret ptr %info
full:
  call void @llvm.trap()
  unreachable
}

define ptr @NRT_MemInfo_alloc_safe_aligned(i64 %size, i32 %align) alwaysinline {
  %info = call ptr @NRT_MemInfo_alloc_aligned(i64 %size, i32 %align)
  ret ptr %info
}

; The arena is emptied as a whole.
define void @NRT_MemInfo_call_dtor(ptr %info) {
  ret void
}

define double @sqrt(double %x) alwaysinline {
  %root = call double @llvm.sqrt.f64(double %x)
  ret double %root
}

; LLVM's own needs a product of 128 bits from a library.
define { i64, i1 } @multiplied(i64 %a, i64 %b) alwaysinline {
  %product = mul i64 %a, %b
  %is_zero = icmp eq i64 %a, 0
  %divisor = select i1 %is_zero, i64 1, i64 %a
  %quotient = sdiv i64 %product, %divisor
  %is_same = icmp eq i64 %quotient, %b
  %is_fine = or i1 %is_zero, %is_same
  %is_over = xor i1 %is_fine, true
  %half = insertvalue { i64, i1 } poison, i64 %product, 0
  %both = insertvalue { i64, i1 } %half, i1 %is_over, 1
  ret { i64, i1 } %both
}

declare double @llvm.sqrt.f64(double)
declare void @llvm.trap()
