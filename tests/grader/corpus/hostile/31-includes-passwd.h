// COMPILE_ERROR: includes a file of the machine
// says: No such file
// SPDX-License-Identifier: MIT-0
%:include "/etc/passwd"
