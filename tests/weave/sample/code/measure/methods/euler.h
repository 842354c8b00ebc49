struct Euler {
  function = "euler";
};
