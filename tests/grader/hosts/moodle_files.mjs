// What Moodle hands out, as its sources make it.
export const handedIn = {
  'Ada Lovelace_4711_assignsubmission_file/one.h': '// score 10\n',
  'Ada Lovelace_4711_assignsubmission_file/1-first/two.h': '// score 4\n',
  'Bob OBrien_4712_assignsubmission_file/one.h': '// score 4\n',
};
// The same without folders, and what an older Moodle has at a folder's end.
export const flat = {
  'Ada Lovelace_4711_assignsubmission_file_one.h': '// score 10\n',
  'Ada Lovelace_4711_assignsubmission_file_two.h': '// score 4\n',
  'Bob OBrien_4712_assignsubmission_file_one.h': '// score 4\n',
};
export const worksheet =
  '\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed",' +
  '"Last modified (submission)","Last modified (grade)","Feedback comments"\r\n' +
  '"Participant 4711","Ada Lovelace",ada@example.org,"Submitted for grading",,20.00,Yes,"Saturday, 8 February 2020, 11:58 PM",-,\r\n' +
  '"Participant 4712","Bob O\'Brien",bob@example.org,"Submitted for grading - 1 hour late",,20.00,Yes,"Sunday, 9 February 2020, 12:59 AM",-,"said ""hm"""\r\n' +
  '"Participant 4713","Cy, C.",cy@example.org,"No submission",,20.00,Yes,-,-,\r\n';
export const roster =
  "First name,Last name,Email address\nAda,Lovelace,ada@example.org\nBob,O'Brien,bob@example.org\nCy,C.,cy@example.org\n";
