# picture of figure10
