// SPDX-License-Identifier: MIT-0
// Plain words that windows.h, and what is usually included with it, makes macros of. A header of
// code/integrate or code/frames has to work where they are.
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define NEAR
#define FAR
#define small char
#define hyper __int64
#define interface struct
#define pascal __stdcall
#define cdecl
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define THIS void
#define PURE = 0
#define TRUE 1
#define FALSE 0
#define STRICT 1
#define ERROR 0
#define IGNORE 0
#define DELETE 0x00010000L
#define INFINITE 0xFFFFFFFF
#define ABSOLUTE 1
#define RELATIVE 2
#define TRANSPARENT 1
#define OPAQUE 2
#define ALTERNATE 1
#define DIFFERENCE 11
#define DOMAIN 1
#define OVERFLOW 3
#define UNDERFLOW 4
#define Yield()
#define GetObject GetObjectW
#define rad1 0x0420
#define grp1 0x0430
#define chx1 0x0410
#define lst1 0x0460
#define ctl1 0x04A0
